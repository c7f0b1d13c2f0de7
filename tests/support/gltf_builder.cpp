// SPDX-License-Identifier: MIT
#include "support/gltf_builder.h"

namespace {

// One white pixel, RGBA.
const std::vector<unsigned char> kPng = {
    0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A, 0x00, 0x00, 0x00, 0x0D, 0x49, 0x48, 0x44, 0x52, 0x00,
    0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x06, 0x00, 0x00, 0x00, 0x1F, 0x15, 0xC4, 0x89, 0x00,
    0x00, 0x00, 0x0B, 0x49, 0x44, 0x41, 0x54, 0x78, 0xDA, 0x63, 0xF8, 0x0F, 0x04, 0x00, 0x09, 0xFB, 0x03,
    0xFD, 0x68, 0xFA, 0x1C, 0xCC, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4E, 0x44, 0xAE, 0x42, 0x60, 0x82};

void appendWord(std::string& out, std::size_t word) {
    for (int byte = 0; byte < 4; ++byte)
        out.push_back(static_cast<char>(word >> (8 * byte)));
}

} // namespace

std::string glb(const std::string& json, const std::string& data) {
    const std::string text = json + std::string((4 - json.size() % 4) % 4, ' ');
    const std::string padded = data + std::string((4 - data.size() % 4) % 4, '\0');
    std::string out = "glTF";
    appendWord(out, 2);
    appendWord(out, 12 + 8 + text.size() + 8 + padded.size());
    appendWord(out, text.size());
    out += "JSON" + text;
    appendWord(out, padded.size());
    return out + std::string("BIN\0", 4) + padded;
}

std::string base64(const std::vector<unsigned char>& bytes) {
    static const char kAlphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned bits = 0;
        for (std::size_t j = 0; j < 3; ++j)
            bits = bits << 8 | (i + j < bytes.size() ? bytes[i + j] : 0u);
        for (std::size_t j = 0; j < 4; ++j)
            text += i + j > bytes.size() ? '=' : kAlphabet[bits >> (18 - 6 * j) & 63];
    }
    return text;
}

int GltfBuilder::append(const char* array, const Json& object) {
    json[array].push_back(object);
    return static_cast<int>(json[array].size()) - 1;
}

void GltfBuilder::setPrimitive(const Json& primitive) {
    json["meshes"] = Json::array({{{"primitives", Json::array({primitive})}}});
    json["nodes"] = Json::array({{{"mesh", 0}}});
    json["scenes"] = Json::array({{{"nodes", {0}}}});
    json["scene"] = 0;
}

void GltfBuilder::setTriangle() {
    setPrimitive({{"attributes", {{"POSITION", floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0})}}}});
}

void GltfBuilder::setTriangles(const std::vector<std::vector<unsigned char>>& images, const char* mimeType) {
    setTriangle();
    Json primitive = json["meshes"][0]["primitives"][0];
    primitive["attributes"]["TEXCOORD_0"] = floats("VEC2", {0, 0, 1, 0, 0, 1});
    json["meshes"][0]["primitives"] = Json::array();
    for (const std::vector<unsigned char>& image : images) {
        const int source = append("images", {{"bufferView", view(image)}, {"mimeType", mimeType}});
        const int texture = append("textures", {{"source", source}});
        primitive["material"] =
            append("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}}}});
        json["meshes"][0]["primitives"].push_back(primitive);
    }
}

int GltfBuilder::appendTexture() {
    const int image = append("images", {{"uri", "data:image/png;base64," + base64(kPng)}});
    return append("textures", {{"source", image}});
}

std::string GltfBuilder::bytes(bool binary) const {
    Json document = json;
    if (!m_bytes.empty() && !document.contains("buffers")) {
        Json buffer{{"byteLength", m_bytes.size()}};
        if (!binary)
            buffer["uri"] = "data:application/octet-stream;base64," + base64(m_bytes);
        document["buffers"] = Json::array({buffer});
    }
    return binary ? glb(document.dump(), {m_bytes.begin(), m_bytes.end()}) : document.dump();
}
