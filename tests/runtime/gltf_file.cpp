// SPDX-License-Identifier: MIT
#include "gltf_file.h"

#include <algorithm>
#include <atomic>
#include <fstream>

#include <unistd.h>

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

std::string glb(const std::string& json, const std::vector<unsigned char>& bytes) {
    const std::string text = json + std::string((4 - json.size() % 4) % 4, ' ');
    std::string data(bytes.begin(), bytes.end());
    data.resize((data.size() + 3) / 4 * 4);
    std::string out = "glTF";
    appendWord(out, 2);
    appendWord(out, 12 + 8 + text.size() + 8 + data.size());
    appendWord(out, text.size());
    out += "JSON" + text;
    appendWord(out, data.size());
    return out + std::string("BIN\0", 4) + data;
}

} // namespace

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

int GltfFile::append(const char* array, const Json& object) {
    json[array].push_back(object);
    return static_cast<int>(json[array].size()) - 1;
}

void GltfFile::setPrimitive(const Json& primitive) {
    json["meshes"] = Json::array({{{"primitives", Json::array({primitive})}}});
    json["nodes"] = Json::array({{{"mesh", 0}}});
    json["scenes"] = Json::array({{{"nodes", {0}}}});
    json["scene"] = 0;
}

void GltfFile::setTriangle() {
    setPrimitive({{"attributes", {{"POSITION", floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0})}}}});
}

int GltfFile::appendTexture() {
    const int image = append("images", {{"uri", "data:image/png;base64," + base64(kPng)}});
    return append("textures", {{"source", image}});
}

std::filesystem::path GltfFile::write(bool binary) const {
    static std::atomic<int> counter = 0;
    const std::filesystem::path path =
        std::filesystem::path(testing::TempDir()) / ("franken_" + std::to_string(getpid()) + "_" +
                                                     std::to_string(counter++) + (binary ? ".glb" : ".gltf"));
    Json document = json;
    if (!m_bytes.empty() && !document.contains("buffers")) {
        Json buffer{{"byteLength", m_bytes.size()}};
        if (!binary)
            buffer["uri"] = "data:application/octet-stream;base64," + base64(m_bytes);
        document["buffers"] = Json::array({buffer});
    }
    std::ofstream(path, std::ios::binary) << (binary ? glb(document.dump(), m_bytes) : document.dump());
    return path;
}

franken::Result<franken::Scene> GltfFile::load(const franken::LoadOptions& options) {
    const std::filesystem::path path = write();
    auto scene = franken::loadGltf(
        path, options, [this](franken::LogLevel, std::string_view text) { warnings.emplace_back(text); });
    std::filesystem::remove(path);
    return scene;
}

franken::Scene GltfFile::loaded() {
    auto scene = load();
    if (scene)
        return *std::move(scene);
    ADD_FAILURE() << toString(scene.error());
    return {};
}

std::vector<std::filesystem::path> gltfFilesBelow(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    if (std::filesystem::exists(folder))
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
            if (entry.path().extension() == ".gltf" || entry.path().extension() == ".glb")
                files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

std::filesystem::path sharedFolder() {
    return std::filesystem::path(FRANKEN_SOURCE_DIR).parent_path() / "shared";
}
