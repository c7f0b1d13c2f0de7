// SPDX-License-Identifier: MIT
#include "gltf_writer.h"

#include <string>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "franken/file_writer.h"

namespace make_model {
namespace {

using Json = nlohmann::ordered_json;
using Bytes = std::vector<std::uint8_t>;
using franken::Result;
using franken::writeFile;

// The numbers that glTF takes over from OpenGL.
constexpr int kUnsignedByte = 5121;
constexpr int kUnsignedShort = 5123;
constexpr int kFloat = 5126;
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;
constexpr int kLinear = 9729;
constexpr int kLinearMipmapLinear = 9987;
constexpr int kRepeat = 10497;
constexpr int kClampToEdge = 33071;

template<typename Vector>
Json list(const Vector& vector) {
    Json array = Json::array();
    for (int i = 0; i < vector.length(); ++i)
        array.push_back(vector[i]);
    return array;
}

void padTo4(Bytes& bytes, std::uint8_t with) { bytes.resize((bytes.size() + 3) / 4 * 4, with); }

// The binary buffer, and the lists that say what lies where in it.
struct Storage {
    Bytes bytes;
    Json views = Json::array();
    Json accessors = Json::array();

    std::size_t addView(const Bytes& content, const Json& properties) {
        views.push_back({{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", content.size()}});
        views.back().update(properties);
        bytes.insert(bytes.end(), content.begin(), content.end());
        padTo4(bytes, 0);
        return views.size() - 1;
    }

    std::size_t addAccessor(Json accessor) {
        accessors.push_back(std::move(accessor));
        return accessors.size() - 1;
    }
};

struct Attribute {
    const char* name;
    const char* type;
    int componentType;
    const void* data;
    std::size_t size; // Of one vertex, bytes.
};

std::vector<Attribute> attributesOf(const Mesh& mesh) {
    std::vector<Attribute> attributes{
        {"POSITION", "VEC3", kFloat, mesh.positions.data(), sizeof(glm::vec3)},
        {"NORMAL", "VEC3", kFloat, mesh.normals.data(), sizeof(glm::vec3)},
    };
    if (!mesh.tangents.empty())
        attributes.push_back({"TANGENT", "VEC4", kFloat, mesh.tangents.data(), sizeof(glm::vec4)});
    if (!mesh.uvs.empty())
        attributes.push_back({"TEXCOORD_0", "VEC2", kFloat, mesh.uvs.data(), sizeof(glm::vec2)});
    if (!mesh.colours.empty())
        attributes.push_back({"COLOR_0", "VEC4", kUnsignedByte, mesh.colours.data(), sizeof(glm::u8vec4)});
    if (!mesh.joints.empty()) {
        attributes.push_back({"JOINTS_0", "VEC4", kUnsignedByte, mesh.joints.data(), sizeof(glm::u8vec4)});
        attributes.push_back({"WEIGHTS_0", "VEC4", kUnsignedByte, mesh.weights.data(), sizeof(glm::u8vec4)});
    }
    return attributes;
}

/// Interleaved; the first attribute has its bounds.
Json addVertices(const std::vector<Attribute>& attributes, const std::vector<glm::vec3>& positions,
                 Storage& storage) {
    Bytes vertices;
    for (std::size_t i = 0; i < positions.size(); ++i)
        for (const Attribute& attribute : attributes) {
            const auto* bytes = static_cast<const std::uint8_t*>(attribute.data) + i * attribute.size;
            vertices.insert(vertices.end(), bytes, bytes + attribute.size);
        }
    const std::size_t stride = vertices.size() / positions.size();
    const std::size_t view = storage.addView(vertices, {{"byteStride", stride}, {"target", kArrayBuffer}});

    glm::vec3 low = positions.front();
    glm::vec3 high = low;
    for (const glm::vec3& position : positions) {
        low = glm::min(low, position);
        high = glm::max(high, position);
    }

    Json names;
    std::size_t offset = 0;
    for (const Attribute& attribute : attributes) {
        Json accessor{{"bufferView", view},
                      {"byteOffset", offset},
                      {"componentType", attribute.componentType},
                      {"count", positions.size()},
                      {"type", attribute.type}};
        if (attribute.componentType == kUnsignedByte && attribute.name != std::string_view("JOINTS_0"))
            accessor["normalized"] = true;
        if (offset == 0)
            accessor.update({{"min", list(low)}, {"max", list(high)}});
        names[attribute.name] = storage.addAccessor(std::move(accessor));
        offset += attribute.size;
    }
    return names;
}

Json toJson(const Mesh& mesh, Storage& storage) {
    const Json attributes = addVertices(attributesOf(mesh), mesh.positions, storage);
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(mesh.indices.data());
    const Bytes indices(bytes, bytes + mesh.indices.size() * sizeof mesh.indices[0]);
    const std::size_t accessor =
        storage.addAccessor({{"bufferView", storage.addView(indices, {{"target", kElementArrayBuffer}})},
                             {"componentType", kUnsignedShort},
                             {"count", mesh.indices.size()},
                             {"type", "SCALAR"}});
    Json primitive{{"attributes", attributes}, {"indices", accessor}, {"material", mesh.material}};
    if (mesh.targets.empty())
        return {{"name", mesh.name}, {"primitives", Json::array({primitive})}};
    Json names;
    for (const Target& target : mesh.targets) {
        names.push_back(target.name);
        primitive["targets"].push_back(
            addVertices({{"POSITION", "VEC3", kFloat, target.positions.data(), sizeof(glm::vec3)},
                         {"NORMAL", "VEC3", kFloat, target.normals.data(), sizeof(glm::vec3)}},
                        target.positions, storage));
    }
    return {{"name", mesh.name},
            {"primitives", Json::array({primitive})},
            {"weights", std::vector<int>(mesh.targets.size(), 0)},
            {"extras", {{"targetNames", names}}}};
}

Json toJson(const Material& material) {
    const auto refer = [](Json& parent, const char* key, std::optional<int> image) {
        if (image)
            parent[key] = {{"index", *image}};
    };
    Json surface = Json::object();
    if (material.baseColour != glm::dvec3(1.0))
        surface["baseColorFactor"] = list(glm::dvec4(material.baseColour, 1.0));
    refer(surface, "baseColorTexture", material.baseColourImage);
    if (material.metallic != 1.0)
        surface["metallicFactor"] = material.metallic;
    if (material.roughness != 1.0)
        surface["roughnessFactor"] = material.roughness;
    refer(surface, "metallicRoughnessTexture", material.metallicRoughnessImage);

    Json json{{"name", material.name}, {"pbrMetallicRoughness", surface}};
    refer(json, "normalTexture", material.normalImage);
    refer(json, "occlusionTexture", material.occlusionImage);
    refer(json, "emissiveTexture", material.emissiveImage);
    if (material.emissive != glm::dvec3(0.0))
        json["emissiveFactor"] = list(material.emissive);
    if (material.doubleSided)
        json["doubleSided"] = true;
    return json;
}

Json toJson(const Node& node) {
    Json json{{"name", node.name}};
    if (node.translation != glm::dvec3(0.0))
        json["translation"] = list(node.translation);
    if (node.rotation != glm::dvec4(0.0, 0.0, 0.0, 1.0))
        json["rotation"] = list(node.rotation);
    if (node.scale != glm::dvec3(1.0))
        json["scale"] = list(node.scale);
    if (!node.children.empty())
        json["children"] = node.children;
    if (node.mesh)
        json["mesh"] = *node.mesh;
    if (node.skin)
        json["skin"] = *node.skin;
    if (node.camera)
        json["camera"] = *node.camera;
    if (node.light)
        json["extensions"] = {{"KHR_lights_punctual", {{"light", *node.light}}}};
    return json;
}

Json toJson(const Camera& camera) {
    return {{"type", "perspective"},
            {"perspective", {{"yfov", camera.verticalFov}, {"znear", camera.near}, {"zfar", camera.far}}}};
}

Json toJson(const DirectionalLight& light) {
    return {{"name", light.name},
            {"type", "directional"},
            {"color", list(light.colour)},
            {"intensity", light.lux}};
}

std::size_t addFloats(const float* values, std::size_t count, const char* type, std::size_t width,
                      Storage& storage) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(values);
    const Bytes content(bytes, bytes + count * width * sizeof(float));
    return storage.addAccessor({{"bufferView", storage.addView(content, Json::object())},
                                {"componentType", kFloat},
                                {"count", count},
                                {"type", type}});
}

Json toJson(const Skin& skin, Storage& storage) {
    return {{"name", skin.name},
            {"joints", skin.joints},
            {"inverseBindMatrices",
             addFloats(&skin.inverseBinds[0][0].x, skin.inverseBinds.size(), "MAT4", 16, storage)}};
}

Json toJson(const Animation& animation, Storage& storage) {
    const std::size_t input = addFloats(animation.times.data(), animation.times.size(), "SCALAR", 1, storage);
    storage.accessors[input].update(
        {{"min", Json::array({animation.times.front()})}, {"max", Json::array({animation.times.back()})}});
    Json channels, samplers;
    for (const Channel& channel : animation.channels) {
        const std::size_t count = channel.values.size();
        const std::size_t output =
            channel.path == "weights"    ? addFloats(channel.values.data(), count, "SCALAR", 1, storage)
            : channel.path == "rotation" ? addFloats(channel.values.data(), count / 4, "VEC4", 4, storage)
                                         : addFloats(channel.values.data(), count / 3, "VEC3", 3, storage);
        channels.push_back(
            {{"sampler", samplers.size()}, {"target", {{"node", channel.node}, {"path", channel.path}}}});
        samplers.push_back({{"input", input}, {"output", output}});
    }
    return {{"name", animation.name}, {"channels", channels}, {"samplers", samplers}};
}

// All but the images and the buffer.
Json toJson(const Model& model, Storage& storage) {
    Json gltf{{"asset", {{"version", "2.0"}, {"generator", "FrankenShader make_model"}}},
              {"extensionsUsed", Json::array({"KHR_lights_punctual"})},
              {"scene", 0}};
    gltf["scenes"].push_back({{"nodes", Json::array({model.nodes.size() - 1})}});
    for (const Node& node : model.nodes)
        gltf["nodes"].push_back(toJson(node));
    for (const Camera& camera : model.cameras)
        gltf["cameras"].push_back(toJson(camera));
    Json& lights = gltf["extensions"]["KHR_lights_punctual"]["lights"];
    for (const DirectionalLight& light : model.lights)
        lights.push_back(toJson(light));
    for (const Mesh& mesh : model.meshes)
        gltf["meshes"].push_back(toJson(mesh, storage));
    for (const Material& material : model.materials)
        gltf["materials"].push_back(toJson(material));
    for (const Skin& skin : model.skins)
        gltf["skins"].push_back(toJson(skin, storage));
    for (const Animation& animation : model.animations)
        gltf["animations"].push_back(toJson(animation, storage));
    if (model.images.empty())
        return gltf;
    for (std::size_t i = 0; i < model.images.size(); ++i)
        gltf["textures"].push_back({{"sampler", 0}, {"source", i}});
    gltf["samplers"].push_back({{"magFilter", kLinear},
                                {"minFilter", kLinearMipmapLinear},
                                {"wrapS", kRepeat},
                                {"wrapT", kClampToEdge}});
    return gltf;
}

void appendWord(Bytes& bytes, std::size_t value) {
    for (int shift = 0; shift < 32; shift += 8)
        bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

void appendChunk(Bytes& file, std::string_view type, const Bytes& content) {
    appendWord(file, content.size());
    file.insert(file.end(), type.begin(), type.end());
    file.insert(file.end(), content.begin(), content.end());
}

Result<void> writeGlb(const Model& model, const std::filesystem::path& path) {
    Storage storage;
    Json gltf = toJson(model, storage);
    for (const NamedImage& image : model.images)
        gltf["images"].push_back({{"name", image.name},
                                  {"mimeType", "image/png"},
                                  {"bufferView", storage.addView(encodePng(image.image), Json::object())}});
    gltf["bufferViews"] = storage.views;
    gltf["accessors"] = storage.accessors;
    gltf["buffers"].push_back({{"byteLength", storage.bytes.size()}});

    const std::string text = gltf.dump();
    Bytes json(text.begin(), text.end());
    padTo4(json, ' ');
    Bytes file{'g', 'l', 'T', 'F'};
    appendWord(file, 2);
    appendWord(file, 12 + 8 + json.size() + 8 + storage.bytes.size());
    appendChunk(file, "JSON", json);
    appendChunk(file, {"BIN\0", 4}, storage.bytes);
    return writeFile(path, file);
}

Result<void> writeFiles(const Model& model, const std::filesystem::path& path) {
    const std::string stem = path.stem().string();
    Storage storage;
    Json gltf = toJson(model, storage);
    for (const NamedImage& image : model.images) {
        const std::string name = stem + "_" + image.name + ".png";
        gltf["images"].push_back({{"name", image.name}, {"uri", name}});
        if (Result<void> written = writeFile(path.parent_path() / name, encodePng(image.image)); !written)
            return written;
    }
    gltf["bufferViews"] = storage.views;
    gltf["accessors"] = storage.accessors;
    gltf["buffers"].push_back({{"uri", stem + ".bin"}, {"byteLength", storage.bytes.size()}});
    if (Result<void> written = writeFile(path.parent_path() / (stem + ".bin"), storage.bytes); !written)
        return written;

    const std::string text = gltf.dump(2) + '\n';
    return writeFile(path, text);
}

} // namespace

Result<void> writeGltf(const Model& model, const std::filesystem::path& path) {
    return path.extension() == ".glb" ? writeGlb(model, path) : writeFiles(model, path);
}

} // namespace make_model
