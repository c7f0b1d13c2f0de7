// SPDX-License-Identifier: MIT
#include <functional>
#include <limits>

#include "malformed/malformed.h"

namespace {

using Json = GltfBuilder::Json;

constexpr std::uint64_t kAlmostOverflow = 18446744073709551608u; ///< 2^64 - 8

struct Row {
    const char* name;
    std::function<void(GltfBuilder&)> damage; ///< Of soundModel().
    const char* code;
    const char* where;
};

std::function<void(GltfBuilder&)> set(const char* pointer, const Json& value) {
    return [=](GltfBuilder& file) { file.json[Json::json_pointer(pointer)] = value; };
}

/// Puts an accessor of these numbers in the place of an attribute.
std::function<void(GltfBuilder&)> attribute(const char* name, const char* type,
                                            const std::vector<float>& numbers) {
    return [=](GltfBuilder& file) {
        const int accessor = file.floats(type, numbers);
        file.json["meshes"][0]["primitives"][0]["attributes"][name] = accessor;
    };
}

std::function<void(GltfBuilder&)> indices(const std::vector<unsigned short>& numbers) {
    return [=](GltfBuilder& file) {
        const int accessor = file.accessor("SCALAR", GltfBuilder::kUShort, numbers);
        file.json["meshes"][0]["primitives"][0]["indices"] = accessor;
    };
}

std::vector<MalformedFile> files(const std::string& group, const std::vector<Row>& rows) {
    std::vector<MalformedFile> files;
    for (const Row& row : rows) {
        GltfBuilder file = soundModel();
        row.damage(file);
        files.push_back({group + row.name, "glb", file.bytes(true), row.code, row.where, {}});
    }
    return files;
}

std::vector<MalformedFile> ranges() {
    return files(
        "range/",
        {{"view-past-its-buffer", set("/bufferViews/0/byteLength", 100000), "gltf.bounds", "/bufferViews/0"},
         {"view-offset-past-its-buffer", set("/bufferViews/0/byteOffset", 100000), "gltf.bounds",
          "/bufferViews/0"},
         {"view-offset-overflows", set("/bufferViews/0/byteOffset", kAlmostOverflow), "gltf.bounds",
          "/bufferViews/0"},
         {"view-length-overflows", set("/bufferViews/0/byteLength", kAlmostOverflow), "gltf.bounds",
          "/bufferViews/0"},
         {"stride-1", set("/bufferViews/0/byteStride", 1), "gltf.type", "/accessors/0"},
         {"stride-256", set("/bufferViews/0/byteStride", 256), "gltf.bounds", "/accessors/0"},
         {"stride-0", set("/bufferViews/0/byteStride", 0), "", ""},
         {"stride-overflows", set("/bufferViews/0/byteStride", kAlmostOverflow), "gltf.bounds",
          "/accessors/0"},
         {"stride-below-the-element", set("/bufferViews/0/byteStride", 8), "gltf.type", "/accessors/0"},
         {"stride-past-the-view", set("/bufferViews/0/byteStride", 252), "gltf.bounds", "/accessors/0"},
         {"accessor-offset-past-its-view", set("/accessors/0/byteOffset", 36), "gltf.bounds", "/accessors/0"},
         {"accessor-offset-overflows", set("/accessors/0/byteOffset", kAlmostOverflow), "gltf.bounds",
          "/accessors/0"},
         {"accessor-count-one-too-many", set("/accessors/0/count", 4), "gltf.bounds", "/accessors/0"},
         {"accessor-count-0", set("/accessors/0/count", 0), "gltf.type", "/accessors/0/count"},
         {"accessor-count-overflows", set("/accessors/0/count", kAlmostOverflow), "gltf.limit",
          "/accessors/0/count"},
         {"accessor-count-times-size-overflows", set("/accessors/0/count", 1537228672809129302u),
          "gltf.limit", "/accessors/0/count"},
         {"normals-that-an-unlit-surface-ignores", set("/accessors/1/count", 2), "", ""},
         {"accessor-count-differs", set("/accessors/3/count", 2), "gltf.type", ""},
         {"accessor-larger-component", set("/accessors/5/componentType", 5125), "gltf.bounds",
          "/accessors/5"},
         {"accessor-larger-type", set("/accessors/3/type", "MAT4"), "gltf.bounds", "/accessors/3"},
         {"min-of-two-numbers", set("/accessors/0/min", {0, 0}), "", ""},
         {"max-of-four-numbers", set("/accessors/0/max", {1, 1, 1, 1}), "", ""},
         {"min-above-max", set("/accessors/0/min/1", 5), "", ""},
         {"max-beyond-floats", set("/accessors/0/max/0", 1e300), "", ""},
         {"min-and-max-that-lie", set("/accessors/0/max", {0.1, 0.1, 0.1}), "", ""},
         {"sparse-count-0", set("/accessors/8/sparse/count", 0), "gltf.type", "/accessors/8/sparse/count"},
         {"sparse-count-above-the-count", set("/accessors/8/sparse/count", 4), "gltf.type",
          "/accessors/8/sparse/count"},
         {"sparse-more-than-its-indices", set("/accessors/8/sparse/count", 3), "gltf.bounds",
          "/accessors/8/sparse/indices"},
         {"sparse-more-than-its-values",
          [](GltfBuilder& file) {
              file.json["accessors"][8]["sparse"]["count"] = 2;
              file.json["accessors"][8]["sparse"]["indices"]["bufferView"] = 7;
          },
          "gltf.bounds", "/accessors/8/sparse/values"},
         {"sparse-indices-of-floats", set("/accessors/8/sparse/indices/componentType", 5126), "gltf.type",
          "/accessors/8/sparse/indices/componentType"},
         {"sparse-offset-past-the-view", set("/accessors/8/sparse/values/byteOffset", 2147483647),
          "gltf.bounds", "/accessors/8/sparse/values"},
         {"sparse-index-past-the-accessor",
          [](GltfBuilder& file) {
              file.json["accessors"][8]["sparse"]["indices"]["bufferView"] =
                  file.view(std::vector<unsigned short>{3});
          },
          "gltf.index-range", "/accessors/8/sparse/indices"}});
}

std::vector<MalformedFile> types() {
    return files(
        "type/",
        {{"component-unknown", set("/accessors/0/componentType", 5130), "gltf.type",
          "/accessors/0/componentType"},
         {"component-int", set("/accessors/0/componentType", 5124), "gltf.type",
          "/accessors/0/componentType"},
         {"component-0", set("/accessors/0/componentType", 0), "gltf.type", "/accessors/0/componentType"},
         {"element-unknown", set("/accessors/0/type", "VEC5"), "gltf.type", "/accessors/0/type"},
         {"indices-of-an-unknown-element", set("/accessors/7/type", "scalar"), "gltf.type",
          "/accessors/7/type"},
         {"positions-of-two-numbers", set("/accessors/0/type", "VEC2"), "gltf.type", ""},
         {"positions-of-shorts", set("/accessors/0/componentType", 5122), "", ""},
         {"normals-of-four-numbers", set("/accessors/2/type", "SCALAR"), "", ""},
         {"joints-normalised", set("/accessors/5/normalized", true), "", ""},
         {"joints-of-floats-past-the-skin", set("/meshes/0/primitives/0/attributes/JOINTS_0", 6),
          "gltf.index-range", "/attributes/JOINTS_0"},
         {"indices-of-vectors", set("/meshes/0/primitives/0/indices", 0), "gltf.type", "/indices"},
         {"indices-of-signed-shorts", set("/accessors/7/componentType", 5122), "gltf.type", "/indices"},
         {"matrices-of-vectors", set("/skins/0/inverseBindMatrices", 0), "gltf.type",
          "/skins/0/inverseBindMatrices"},
         {"fewer-matrices-than-joints", set("/skins/0/joints", {1, 2}), "gltf.type",
          "/skins/0/inverseBindMatrices"},
         {"skin-without-joints", set("/skins/0/joints", Json::array()), "gltf.type", "/skins/0/joints"},
         {"target-of-two-numbers", set("/meshes/0/primitives/0/targets/0/POSITION", 3), "gltf.type",
          "/targets/0/POSITION"}});
}

std::vector<MalformedFile> values() {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    return files(
        "value/",
        {{"position-nan", attribute("POSITION", "VEC3", {0, 0, 0, nan, 0, 0, 0, 1, 0}), "gltf.value",
          "/accessors/10"},
         {"position-infinite", attribute("POSITION", "VEC3", {0, 0, 0, inf, 0, 0, 0, 1, 0}), "gltf.value",
          "/accessors/10"},
         {"normal-nan", attribute("NORMAL", "VEC3", {0, 0, nan, 0, 0, 1, 0, 0, 1}), "gltf.value",
          "/accessors/10"},
         {"normals-zero", attribute("NORMAL", "VEC3", std::vector<float>(9, 0.0f)), "", ""},
         {"normals-huge", attribute("NORMAL", "VEC3", std::vector<float>(9, 3e38f)), "", ""},
         {"tangents-zero", attribute("TANGENT", "VEC4", std::vector<float>(12, 0.0f)), "", ""},
         {"positions-huge", attribute("POSITION", "VEC3", std::vector<float>(9, 3e38f)), "", ""},
         {"weights-zero", attribute("WEIGHTS_0", "VEC4", std::vector<float>(12, 0.0f)), "", ""},
         {"weights-cancel", attribute("WEIGHTS_0", "VEC4", {1, -1, 0, 0, 1, -1, 0, 0, 1, -1, 0, 0}), "", ""},
         {"weight-beyond-floats", set("/nodes/0/weights", {1e39}), "gltf.value", "/nodes/0/weights"},
         {"mesh-weight-beyond-floats", set("/meshes/0/weights", {-1e300}), "gltf.value", "/meshes/0/weights"},
         {"translation-beyond-floats", set("/nodes/1/translation", {0, 1e300, 0}), "gltf.value",
          "/nodes/1/translation"},
         {"rotation-zero", set("/nodes/1/rotation", {0, 0, 0, 0}), "", ""},
         {"scales-that-multiply-to-infinity",
          [](GltfBuilder& file) {
              file.json["nodes"][0]["scale"] = {1e30, 1, 1};
              file.json["nodes"][1]["scale"] = {1e30, 1, 1};
          },
          "gltf.value", "/nodes/1"},
         {"mode-7", set("/meshes/0/primitives/0/mode", 7), "gltf.value", "/meshes/0/primitives/0/mode"},
         {"mode-points", set("/meshes/0/primitives/0/mode", 0), "", ""},
         {"alpha-mode-unknown", set("/materials/0/alphaMode", "GLASS"), "gltf.value",
          "/materials/0/alphaMode"},
         {"factor-beyond-floats", set("/materials/0/emissiveFactor", {1e300, 0, 0}), "gltf.value",
          "/materials/0/emissiveFactor"},
         {"factor-negative", set("/materials/0/pbrMetallicRoughness/metallicFactor", -3), "", ""},
         {"emission-negative",
          set("/materials/0/extensions/KHR_materials_emissive_strength/emissiveStrength", -1), "gltf.value",
          "KHR_materials_emissive_strength"},
         {"uv-transform-beyond-floats",
          set("/materials/0/normalTexture/extensions/KHR_texture_transform/scale", {1e300, 1}), "gltf.value",
          "KHR_texture_transform"},
         {"uv-stream-7", set("/materials/0/normalTexture/extensions/KHR_texture_transform/texCoord", 7), "",
          ""},
         {"wrap-unknown", set("/samplers/0/wrapS", 1), "gltf.value", "/samplers/0/wrapS"},
         {"filter-unknown", set("/samplers/0/minFilter", 1), "gltf.value", "/samplers/0/minFilter"},
         {"camera-type-unknown", set("/cameras/0/type", "fisheye"), "", ""},
         {"camera-near-0", set("/cameras/0/perspective/znear", 0), "", ""},
         {"camera-far-before-near", set("/cameras/0/perspective/zfar", 0.01), "", ""},
         {"camera-flat", set("/cameras/1/orthographic/xmag", 0), "", ""},
         {"light-type-unknown", set("/extensions/KHR_lights_punctual/lights/0/type", "neon"), "", ""},
         {"light-negative", set("/extensions/KHR_lights_punctual/lights/0/intensity", -1), "gltf.value",
          "/lights/0"},
         {"light-cones-crossed", set("/extensions/KHR_lights_punctual/lights/0/spot/innerConeAngle", 0.6), "",
          ""}});
}

std::vector<MalformedFile> links() {
    return files(
        "link/",
        {{"vertex-index-past-the-end", indices({0, 1, 3}), "gltf.vertex-range", "/indices"},
         {"vertex-index-65535", indices({0, 1, 65535}), "gltf.vertex-range", "/indices"},
         {"two-indices", indices({0, 1}), "", ""},
         {"triangles-without-area", indices({0, 0, 0, 1, 1, 2}), "", ""},
         {"joint-past-the-skin",
          [](GltfBuilder& file) {
              const int joints =
                  file.accessor("VEC4", GltfBuilder::kUByte, std::vector<unsigned char>(12, 200));
              file.json["meshes"][0]["primitives"][0]["attributes"]["JOINTS_0"] = joints;
          },
          "gltf.index-range", "/attributes/JOINTS_0"},
         {"second-joints-past-the-skin",
          [](GltfBuilder& file) {
              auto& attributes = file.json["meshes"][0]["primitives"][0]["attributes"];
              attributes["JOINTS_1"] =
                  file.accessor("VEC4", GltfBuilder::kUByte, std::vector<unsigned char>(12, 200));
              attributes["WEIGHTS_1"] = attributes["WEIGHTS_0"];
          },
          "gltf.index-range", "/attributes/JOINTS_1"},
         {"second-joints-without-weights",
          [](GltfBuilder& file) {
              auto& attributes = file.json["meshes"][0]["primitives"][0]["attributes"];
              attributes["JOINTS_1"] = attributes["JOINTS_0"];
          },
          "", ""},
         {"instances-of-vertices-of-another-count",
          [](GltfBuilder& file) {
              file.json["nodes"][0].erase("skin");
              file.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
                  {"TRANSLATION", 0}, {"SCALE", file.floats("VEC3", {1, 1, 1})}};
          },
          "gltf.type", "/EXT_mesh_gpu_instancing/attributes/SCALE"},
         {"instances-moved-by-normalized-bytes",
          [](GltfBuilder& file) {
              file.json["nodes"][0].erase("skin");
              const int moves = file.accessor("VEC3", GltfBuilder::kByte, std::vector<signed char>{1, 2, 3});
              file.json["accessors"][static_cast<std::size_t>(moves)]["normalized"] = true;
              file.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
                  {"TRANSLATION", moves}};
          },
          "gltf.type", "/EXT_mesh_gpu_instancing/attributes/TRANSLATION"},
         {"instances-scaled-by-four-numbers",
          [](GltfBuilder& file) {
              file.json["nodes"][0].erase("skin");
              file.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
                  {"SCALE", file.floats("VEC4", {1, 1, 1, 1})}};
          },
          "gltf.type", "/EXT_mesh_gpu_instancing/attributes/SCALE"},
         {"instances-past-the-accessors",
          [](GltfBuilder& file) {
              file.json["nodes"][0].erase("skin");
              file.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"SCALE", 999}};
          },
          "gltf.index-range", "/EXT_mesh_gpu_instancing/attributes/SCALE"},
         {"skinned-without-joints",
          [](GltfBuilder& file) { file.json["meshes"][0]["primitives"][0]["attributes"].erase("JOINTS_0"); },
          "", ""},
         {"without-positions",
          [](GltfBuilder& file) { file.json["meshes"][0]["primitives"][0]["attributes"].erase("POSITION"); },
          "", ""},
         {"without-attributes", set("/meshes/0/primitives/0/attributes", Json::object()), "", ""},
         {"node-is-its-own-child", set("/nodes/1/children", {1}), "gltf.node-tree", "/nodes/1"},
         {"node-in-a-cycle-of-two", set("/nodes/1/children", {0}), "gltf.node-tree", "/nodes/0"},
         {"node-with-two-parents", set("/nodes/1/children", {2}), "gltf.node-tree", "/nodes/2"},
         {"node-twice-the-same-child", set("/nodes/0/children", {1, 1, 2}), "gltf.node-tree", "/nodes/1"},
         {"node-twice-in-the-scene", set("/scenes/0/nodes", {0, 0}), "", ""},
         {"scene-past-the-end", set("/scene", 1), "gltf.index-range", "/scene"},
         {"image-of-view-and-uri", set("/images/0/bufferView", 0), "gltf.schema", "/images/0"},
         {"texture-without-image", set("/textures/0", Json::object()), "", ""}});
}

} // namespace

std::vector<MalformedFile> malformedData() {
    std::vector<MalformedFile> all = ranges();
    for (const auto& group : {types(), values(), links()})
        all.insert(all.end(), group.begin(), group.end());
    return all;
}
