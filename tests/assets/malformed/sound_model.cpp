// SPDX-License-Identifier: MIT
#include "malformed/malformed.h"

namespace {

using Json = GltfBuilder::Json;

Json material(int texture) {
    const Json info{{"index", texture},
                    {"texCoord", 0},
                    {"extensions",
                     {{"KHR_texture_transform",
                       {{"offset", {0.5, 0}}, {"rotation", 1}, {"scale", {2, 2}}, {"texCoord", 0}}}}}};
    Json normal = info, occlusion = info;
    normal["scale"] = 0.5;
    occlusion["strength"] = 0.5;
    return {{"name", "paint"},
            {"pbrMetallicRoughness",
             {{"baseColorFactor", {1, 1, 1, 1}},
              {"baseColorTexture", info},
              {"metallicFactor", 0.5},
              {"roughnessFactor", 0.5},
              {"metallicRoughnessTexture", info}}},
            {"normalTexture", normal},
            {"occlusionTexture", occlusion},
            {"emissiveTexture", info},
            {"emissiveFactor", {1, 1, 1}},
            {"alphaMode", "MASK"},
            {"alphaCutoff", 0.5},
            {"doubleSided", true},
            {"extensions",
             {{"KHR_materials_emissive_strength", {{"emissiveStrength", 2}}},
              {"KHR_materials_unlit", Json::object()}}}};
}

void addTriangle(GltfBuilder& file) {
    const std::vector<float> zeros(12, 0.0f);
    Json attributes{
        {"POSITION", file.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0})},
        {"NORMAL", file.floats("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1})},
        {"TANGENT", file.floats("VEC4", {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1})},
        {"TEXCOORD_0", file.floats("VEC2", {0, 0, 1, 0, 0, 1})},
        {"COLOR_0", file.floats("VEC4", std::vector<float>(12, 1.0f))},
        {"JOINTS_0", file.accessor("VEC4", GltfBuilder::kUByte, std::vector<unsigned char>(12, 0))},
        {"WEIGHTS_0", file.floats("VEC4", {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0})}};
    file.json["accessors"][0]["min"] = {0, 0, 0};
    file.json["accessors"][0]["max"] = {1, 1, 0};
    const int indices = file.accessor("SCALAR", GltfBuilder::kUShort, std::vector<unsigned short>{0, 1, 2});
    const int target =
        file.append("accessors", {{"componentType", GltfBuilder::kFloat}, {"count", 3}, {"type", "VEC3"}});
    file.json["accessors"][static_cast<std::size_t>(target)]["sparse"] = {
        {"count", 1},
        {"indices",
         {{"bufferView", file.view(std::vector<unsigned short>{2})},
          {"byteOffset", 0},
          {"componentType", GltfBuilder::kUShort}}},
        {"values", {{"bufferView", file.view(std::vector<float>{0, 0, 1})}, {"byteOffset", 0}}}};
    file.setPrimitive({{"attributes", attributes},
                       {"indices", indices},
                       {"material", 0},
                       {"mode", 4},
                       {"targets", {{{"POSITION", target}}}}});
    file.json["meshes"][0]["weights"] = {0.5};
    file.json["meshes"][0]["name"] = "triangle";
    file.json["scenes"][0]["name"] = "stage";
}

void addCameras(GltfBuilder& file) {
    file.json["cameras"] = {
        {{"name", "near"},
         {"type", "perspective"},
         {"perspective", {{"aspectRatio", 1.5}, {"yfov", 0.8}, {"zfar", 10}, {"znear", 0.1}}}},
        {{"name", "far"},
         {"type", "orthographic"},
         {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"zfar", 10}, {"znear", 0.1}}}}};
}

void addNodes(GltfBuilder& file) {
    file.json["nodes"] = {
        {{"name", "root"}, {"mesh", 0}, {"skin", 0}, {"children", {1, 2}}, {"weights", {0.5}}},
        {{"name", "joint"},
         {"translation", {0, 0, 1}},
         {"rotation", {0, 0, 0, 1}},
         {"scale", {1, 1, 1}},
         {"camera", 0}},
        {{"name", "lamp"},
         {"camera", 1},
         {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}},
         {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}}};
}

} // namespace

// Each property that the schema of the loader knows occurs at least once; unused ones would test nothing.
GltfBuilder soundModel() {
    GltfBuilder file;
    const int texture = file.appendTexture();
    addTriangle(file);
    file.json["extensionsUsed"] = {"KHR_texture_transform"};
    file.json["extensionsRequired"] = {"KHR_texture_transform"};
    file.json["materials"] =
        Json::array({material(texture)}); // not { }: compilers disagree about one element
    file.json["samplers"] = {{{"magFilter", 9729}, {"minFilter", 9987}, {"wrapS", 10497}, {"wrapT", 10497}}};
    file.json["textures"][0]["sampler"] = 0;
    file.json["textures"][0]["name"] = "texture";
    file.json["images"][0]["name"] = "pixel";
    file.json["images"][0]["mimeType"] = "image/png";
    file.json["bufferViews"][0]["target"] = 34962;
    file.json["bufferViews"][0]["byteStride"] = 12;
    file.json["accessors"][0]["byteOffset"] = 0;
    file.json["accessors"][0]["normalized"] = false;
    file.json["accessors"][0]["name"] = "positions";
    const int matrices = file.floats("MAT4", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    file.json["skins"] = {
        {{"name", "skin"}, {"joints", {1}}, {"inverseBindMatrices", matrices}, {"skeleton", 1}}};
    addCameras(file);
    file.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"name", "spot"},
         {"type", "spot"},
         {"color", {1, 1, 1}},
         {"intensity", 5},
         {"range", 9},
         {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.5}}}}};
    addNodes(file);
    return file;
}
