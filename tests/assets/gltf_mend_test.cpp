// SPDX-License-Identifier: MIT
// Faults with one reading, and faults in what nothing drawn needs: the file loads, says so once by a code,
// and what is drawn is right.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>

#include <glm/geometric.hpp>

#include "gltf_file.h"

namespace {

using franken::Scene;
using Json = GltfFile::Json;

/// A lit triangle with indices, normals, colours and texture coordinates that no material samples.
GltfFile sound() {
    GltfFile file;
    file.setPrimitive(
        {{"attributes",
          {{"POSITION", file.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0})},
           {"NORMAL", file.floats("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1})},
           {"TEXCOORD_0", file.floats("VEC2", {0, 0, 1, 0, 0, 1})}}},
         {"indices", file.accessor("SCALAR", GltfFile::kUShort, std::vector<std::uint16_t>{0, 1, 2})},
         {"material", 0}});
    file.json["materials"] = Json::array({{{"name", "paint"}}});
    return file;
}

Json& primitiveOf(GltfFile& file) { return file.json["meshes"][0]["primitives"][0]; }

struct Row {
    const char* name;
    std::function<void(GltfFile&)> damage;
    const char* code; ///< Of the warning; empty for none.
    int count = 1;    ///< Of warnings.
};

std::function<void(GltfFile&)> set(const char* pointer, const Json& value) {
    return [=](GltfFile& file) { file.json[Json::json_pointer(pointer)] = value; };
}

std::function<void(GltfFile&)> attribute(const char* name, const std::function<int(GltfFile&)>& make) {
    return [=](GltfFile& file) { primitiveOf(file)["attributes"][name] = make(file); };
}

class Mended : public testing::TestWithParam<Row> {};

TEST_P(Mended, IsDrawnAndSaysSo) {
    GltfFile file = sound();
    ASSERT_TRUE(file.load());
    ASSERT_TRUE(file.warnings.empty()) << file.warnings[0];
    GetParam().damage(file);
    const Scene scene = file.loaded();
    ASSERT_EQ(scene.instances.size(), 1u);
    const franken::Primitive& primitive = scene.meshes[0].primitives[0];
    EXPECT_EQ(primitive.indices, (std::vector<std::uint32_t>{0, 1, 2}));
    ASSERT_EQ(primitive.positions.size(), 3u);
    EXPECT_EQ(primitive.positions[1], glm::vec3(1, 0, 0));
    for (const glm::vec3& normal : primitive.normals)
        EXPECT_NEAR(glm::length(normal - glm::vec3(0, 0, 1)), 0, 1e-6);
    const std::string code = GetParam().code;
    EXPECT_EQ(std::count_if(file.warnings.begin(), file.warnings.end(),
                            [&](const std::string& text) { return text.ends_with("[" + code + "]"); }),
              code.empty() ? 0 : GetParam().count)
        << (file.warnings.empty() ? "" : file.warnings[0]);
}

int bytes(GltfFile& file, const char* type, bool normalized, const std::vector<std::uint8_t>& values) {
    return file.accessor(type, GltfFile::kUByte, values, normalized);
}

INSTANTIATE_TEST_SUITE_P(
    Formats, Mended,
    testing::Values(Row{"strideOfZero", set("/bufferViews/0/byteStride", 0), "gltf.mended"},
                    Row{"strideOfAnotherNumber",
                        [](GltfFile& file) {
                            std::vector<std::uint8_t> packed(9, 0); // three bytes each: no multiple of four
                            packed[3] = packed[7] = 1;
                            file.json["extensionsUsed"] = {"KHR_mesh_quantization"};
                            const int position = file.accessor("VEC3", GltfFile::kUByte, packed);
                            file.json["bufferViews"].back()["byteStride"] = 3;
                            primitiveOf(file)["attributes"]["POSITION"] = position;
                        },
                        "gltf.mended"},
                    Row{"strideOfIndices", set("/bufferViews/3/byteStride", 2), "gltf.mended", 2},
                    Row{"strideOfIndicesThatDoesNotFit", set("/bufferViews/3/byteStride", 4), "gltf.mended"},
                    Row{"normalizedIndices", set("/accessors/3/normalized", true), "gltf.mended"},
                    Row{"quantizedUndeclared",
                        [](GltfFile& file) {
                            primitiveOf(file)["attributes"]["POSITION"] =
                                file.accessor("VEC3", GltfFile::kShort,
                                              std::vector<std::int16_t>{0, 0, 0, 1, 0, 0, 0, 1, 0});
                        },
                        "gltf.mended"},
                    Row{"normalsInShorts",
                        attribute("NORMAL",
                                  [](GltfFile& file) {
                                      return file.accessor(
                                          "VEC3", GltfFile::kShort,
                                          std::vector<std::int16_t>{0, 0, 99, 0, 0, 7, 0, 0, 32767});
                                  }),
                        "gltf.mended"},
                    Row{"normalsOfNoLength",
                        attribute("NORMAL",
                                  [](GltfFile& file) {
                                      return file.floats("VEC3", {0, 0, 0, 0, 0, 1, 0, 0, 0});
                                  }),
                        "gltf.mended"},
                    Row{"normalsOfHugeLength",
                        attribute("NORMAL",
                                  [](GltfFile& file) {
                                      return file.floats("VEC3", {0, 0, 3e38f, 0, 0, 1e-38f, 0, 0, 1});
                                  }),
                        ""},
                    Row{"weightsOfBytes",
                        [](GltfFile& file) {
                            primitiveOf(file)["attributes"]["JOINTS_0"] =
                                file.floats("VEC4", {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
                            primitiveOf(file)["attributes"]["WEIGHTS_0"] =
                                bytes(file, "VEC4", false, {255, 0, 0, 0, 7, 0, 0, 0, 255, 0, 0, 0});
                            file.json["nodes"].push_back(Json::object());
                            file.json["nodes"].push_back(Json::object());
                            file.json["nodes"][0]["skin"] = 0;
                            file.json["skins"] = {{{"joints", {2, 1}}}};
                        },
                        "gltf.mended", 2}),
    [](const auto& row) { return row.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Properties, Mended,
    testing::Values(Row{"nulls",
                        [](GltfFile& file) {
                            for (const char* at :
                                 {"/nodes/0/name", "/nodes/0/children", "/nodes/0/skin", "/nodes/0/matrix",
                                  "/materials/0/name", "/materials/0/emissiveTexture", "/animations",
                                  "/skins", "/extensions", "/accessors/0/min",
                                  "/meshes/0/primitives/0/attributes/COLOR_0",
                                  "/materials/0/extensions/KHR_materials_unlit"})
                                file.json[Json::json_pointer(at)] = nullptr;
                        },
                        "gltf.mended"},
                    Row{"numberAsName", set("/materials/0/name", 7), "gltf.mended"},
                    Row{"listAsName", set("/nodes/0/name", Json::array({1})), "gltf.mended"},
                    Row{"numberAsVersion", set("/asset/version", 2.0), "gltf.mended"},
                    Row{"minAboveMax",
                        [](GltfFile& file) {
                            file.json["accessors"][0]["min"] = {1, 1, 0};
                            file.json["accessors"][0]["max"] = {-1, 0, 0};
                        },
                        "gltf.mended"},
                    Row{"minOfNulls", set("/accessors/0/min", {nullptr, nullptr, nullptr}), "gltf.mended"},
                    Row{"minOfWords", set("/accessors/0/min", "low"), "gltf.mended"},
                    Row{"minAndMaxOfTwoLengths",
                        [](GltfFile& file) {
                            file.json["accessors"][0]["min"] = {0, 0};
                            file.json["accessors"][0]["max"] = {1, 1, 1};
                        },
                        "gltf.mended"},
                    Row{"harmlessRequired",
                        set("/extensionsRequired", {"KHR_xmp_json_ld", "KHR_materials_clearcoat"}),
                        "gltf.left-out", 2}),
    [](const auto& row) { return row.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Unneeded, Mended,
    testing::Values(
        Row{"accessorOfAnAnimation",
            [](GltfFile& file) {
                file.append("accessors", {{"componentType", 5126}, {"count", 0}, {"type", "SCALAR"}});
            },
            "gltf.unneeded"},
        Row{"accessorOfNoType",
            [](GltfFile& file) {
                file.append("accessors", {{"componentType", 1}, {"count", "many"}, {"type", "VEC9"}});
            },
            "gltf.unneeded"},
        Row{"uvOfScalars",
            attribute("TEXCOORD_1",
                      [](GltfFile& file) {
                          return file.floats("SCALAR", {0, 0, 0});
                      }),
            "gltf.unneeded"},
        Row{"uvOfAnotherCount",
            attribute("TEXCOORD_0",
                      [](GltfFile& file) {
                          return file.floats("VEC2", {0, 0});
                      }),
            "gltf.unneeded"},
        Row{"tangentsOfThree",
            attribute("TANGENT", [](GltfFile& file) { return file.floats("VEC3", std::vector<float>(9)); }),
            "gltf.unneeded"},
        Row{"jointsWithoutASkin",
            attribute("JOINTS_0", [](GltfFile& file) { return file.floats("VEC3", std::vector<float>(9)); }),
            "gltf.unneeded"},
        Row{"ownAttribute",
            attribute("_OWN",
                      [](GltfFile& file) {
                          return file.floats("VEC2", {0, 0});
                      }),
            "gltf.unneeded"},
        Row{"targetWithoutWeight",
            [](GltfFile& file) {
                primitiveOf(file)["targets"] = {{{"POSITION", file.floats("VEC2", {0, 0})}}};
            },
            "gltf.unneeded"},
        Row{"cameraNumbers",
            [](GltfFile& file) {
                file.json["cameras"] = {
                    {{"type", "perspective"}, {"perspective", {{"yfov", 0}, {"znear", 1}}}}};
                file.json["nodes"][0]["camera"] = 0;
            },
            "gltf.unneeded"},
        Row{"cameraWithoutNumbers",
            [](GltfFile& file) {
                file.json["cameras"] = {{{"type", "orthographic"}}, 5, {{"type", "fisheye"}}};
                file.json["nodes"][0]["camera"] = 2;
            },
            "gltf.unneeded", 3},
        Row{"materialOutsideTheScene",
            [](GltfFile& file) {
                file.append("materials", {{"alphaMode", 3}, {"doubleSided", "yes"}});
            },
            "gltf.unneeded"},
        Row{"samplerOfNoTexture",
            [](GltfFile& file) {
                file.append("samplers", {{"wrapS", "clamp"}});
            },
            "gltf.unneeded"},
        Row{"skinOfNoNode",
            [](GltfFile& file) {
                file.append("skins", {{"joints", Json::array()}});
            },
            "gltf.unneeded"},
        Row{"nodeOutsideTheScene",
            [](GltfFile& file) {
                file.append("nodes", {{"scale", {1e300, 1, 1}}});
            },
            "gltf.unneeded"},
        Row{"lightOfNoNode",
            [](GltfFile& file) {
                file.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "spot"}},
                                                                            {{"type", 5}}};
            },
            "gltf.unneeded", 2},
        Row{"meshOutsideTheScene",
            [](GltfFile& file) {
                file.append("meshes", {{"primitives", {{{"attributes", {{"POSITION", 2}}}, {"mode", 9}}}}});
            },
            ""}),
    [](const auto& row) { return row.param.name; });

TEST(GltfMended, UnnormalisedColoursAreNormalised) {
    GltfFile file = sound();
    primitiveOf(file)["attributes"]["COLOR_0"] =
        bytes(file, "VEC4", false, {0, 255, 0, 255, 51, 0, 0, 255, 0, 0, 0, 0});
    const Scene scene = file.loaded();
    EXPECT_EQ(scene.meshes[0].primitives[0].colors[0], glm::vec4(0, 1, 0, 1));
    EXPECT_NEAR(scene.meshes[0].primitives[0].colors[1].r, 0.2f, 1e-6);
}

TEST(GltfMended, ConesAreAtMostAHalfSpace) {
    const auto light = [](double inner, double outer) {
        GltfFile file;
        file.json["extensions"]["KHR_lights_punctual"]["lights"] = {
            {{"type", "spot"},
             {"range", -2},
             {"spot", {{"innerConeAngle", inner}, {"outerConeAngle", outer}}}}};
        file.json["nodes"] = {{{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}}};
        const Scene scene = file.loaded();
        EXPECT_EQ(file.warnings.size(), 2u) << "of the cones and of the range";
        return scene.lights.at(0);
    };
    EXPECT_FLOAT_EQ(light(0.3, 0.3).innerConeAngle, 0.3f);
    EXPECT_FLOAT_EQ(light(0.9, 0.3).innerConeAngle, 0.3f);
    EXPECT_FLOAT_EQ(light(-1, 0.3).innerConeAngle, 0);
    EXPECT_FLOAT_EQ(light(0.5, 3).outerConeAngle, 1.5707964f);
    EXPECT_EQ(light(0.5, 3).range, 0);
}

TEST(GltfMended, UvsOfThreeNumbersAreTheFirstTwo) {
    GltfFile file = sound();
    file.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = file.appendTexture();
    primitiveOf(file)["attributes"]["TEXCOORD_0"] = file.floats("VEC3", {0, 1, 9, 2, 3, 9, 4, 5, 9});
    EXPECT_EQ(file.loaded().meshes[0].primitives[0].uv[0], (std::vector<glm::vec2>{{0, 1}, {2, 3}, {4, 5}}));
    primitiveOf(file)["attributes"]["TEXCOORD_0"] = file.floats("SCALAR", {0, 1, 9});
    EXPECT_EQ(file.load().error().code, "gltf.type") << "which the material needs";
}

TEST(GltfMended, WithoutItsTextureNothingGlows) {
    GltfFile file = sound();
    file.json["materials"][0]["emissiveFactor"] = {1, 1, 1};
    EXPECT_EQ(file.loaded().materials[0].factors.emissive, (franken::Float3{1, 1, 1}));
    file.append("images", {{"uri", "missing.png"}});
    file.append("textures", {{"source", 0}});
    file.append("textures", Json::object());
    for (const int texture : {0, 1}) {
        file.json["materials"][0]["emissiveTexture"] = {{"index", texture}};
        EXPECT_EQ(file.loaded().materials[0].factors.emissive, (franken::Float3{0, 0, 0})) << texture;
    }
    file.json["materials"][0]["emissiveTexture"] = {{"index", file.appendTexture()}, {"texCoord", 2}};
    EXPECT_EQ(file.loaded().materials[0].factors.emissive, (franken::Float3{0, 0, 0}))
        << "a third set of coordinates";
    file.json["materials"][0]["emissiveTexture"]["texCoord"] = 0;
    EXPECT_EQ(file.loaded().materials[0].factors.emissive, (franken::Float3{1, 1, 1}));
}

TEST(GltfMended, DataUrisInAllTheirForms) {
    GltfFile file;
    file.setTriangle();
    const Json whole = Json::parse(file.bytes(false));
    const std::string uri = whole["buffers"][0]["uri"];
    const std::string base64 = uri.substr(uri.find(',') + 1);
    std::string escaped;
    for (const char c : base64) {
        char text[4];
        std::snprintf(text, sizeof text, "%%%02X", static_cast<unsigned>(static_cast<unsigned char>(c)));
        escaped += text;
    }
    for (const std::string& form :
         {"DATA:application/octet-stream;BASE64," + base64, "data:;base64," + escaped,
          "data:;base64," + base64.substr(0, 9) + "\r\n\t " + base64.substr(9), " \ndata:;base64," + base64,
          "data:application/gltf-buffer;charset=utf-8;base64," + base64.substr(0, base64.find('='))}) {
        file.json["buffers"] = {{{"byteLength", 36}, {"uri", form}}};
        EXPECT_EQ(file.loaded().meshes.at(0).primitives[0].positions[1], glm::vec3(1, 0, 0)) << form;
    }
    for (const std::string& form : {"data:;base64," + base64.substr(0, 8) + "==" + base64.substr(8),
                                    "data:;base64,*" + base64, "data:;base64%2C" + base64}) {
        file.json["buffers"] = {{{"byteLength", 36}, {"uri", form}}};
        EXPECT_EQ(file.load().error().code, "gltf.buffer") << form;
    }
}

TEST(GltfMended, CamerasStandAsInTheFile) {
    GltfFile file = sound();
    const Json lens{{"yfov", 1}, {"znear", 1}};
    file.json["cameras"] = {{{"name", "A"}, {"type", "perspective"}, {"perspective", lens}},
                            {{"name", "B"}, {"type", "perspective"}, {"perspective", lens}}};
    file.json["nodes"] = {{{"mesh", 0}, {"camera", 1}, {"name", "b"}}, {{"camera", 0}, {"name", "a"}}};
    file.json["scenes"][0]["nodes"] = {0, 1};
    const Scene scene = file.loaded();
    ASSERT_EQ(scene.cameras.size(), 2u);
    EXPECT_EQ(scene.cameras[0].name, "A");
    EXPECT_EQ(scene.cameras[0].node, "a");
    EXPECT_EQ(scene.cameras[1].index, 1);
}

// glTF 2.0, 3.7.4. The joints are mirrored with the node, or alone, or not at all.
TEST(GltfMended, TheNodeSaysHowASkinWinds) {
    for (const bool node : {false, true})
        for (const bool joint : {false, true}) {
            GltfFile file = sound();
            primitiveOf(file)["attributes"]["JOINTS_0"] =
                bytes(file, "VEC4", false, std::vector<std::uint8_t>(12, 0));
            primitiveOf(file)["attributes"]["WEIGHTS_0"] =
                file.floats("VEC4", {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
            primitiveOf(file)["attributes"].erase("NORMAL");
            file.json["skins"] = {{{"joints", {1}}}};
            file.json["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"scale", {node ? -1 : 1, 1, 1}}},
                                  {{"scale", {joint ? -1 : 1, 1, 1}}}};
            file.json["scenes"][0]["nodes"] = {0, 1};
            const Scene scene = file.loaded();
            const franken::Primitive& primitive = scene.meshes.at(0).primitives[0];
            EXPECT_EQ(scene.instances[0].mirrored, node);
            EXPECT_EQ(primitive.normals[0], glm::vec3(0, 0, node == joint ? 1 : -1)) << node << joint;
        }
}

TEST(GltfMended, FarFromTheOriginAMillimetreIsThere) {
    GltfFile file = sound();
    file.json["nodes"] = {{{"translation", {6378137.0, -4131346.164399078, 12.001}}, {"children", {1}}},
                          {{"mesh", 0}, {"translation", {0.001, 0.25, -12}}}};
    const Scene scene = file.loaded();
    EXPECT_NEAR(scene.instances.at(0).world[3].x - 6378137.0, 0.001, 1e-8);
    EXPECT_NEAR(scene.instances[0].world[3].y + 4131345.914399078, 0, 1e-8);
    EXPECT_NEAR(scene.bounds().max.x - scene.bounds().min.x, 1, 1e-8);
}

} // namespace
