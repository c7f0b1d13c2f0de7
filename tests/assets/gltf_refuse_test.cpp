// SPDX-License-Identifier: MIT
// What is refused, with which code, and where the message points.
#include <functional>

#include "gltf_file.h"
#include "support/shell.h"

namespace {

using Json = GltfFile::Json;

struct Row {
    const char* name;
    std::function<void(GltfFile&)> damage; ///< Of a triangle with a material, a texture and indices.
    const char* code;
    const char* where;
};

GltfFile sound() {
    GltfFile file;
    const int texture = file.appendTexture();
    file.setTriangle();
    file.json["materials"] = {{{"normalTexture", {{"index", texture}}}}};
    Json& primitive = file.json["meshes"][0]["primitives"][0];
    primitive["material"] = 0;
    primitive["indices"] = file.accessor("SCALAR", GltfFile::kUShort, std::vector<unsigned short>{0, 1, 2});
    return file;
}

std::function<void(GltfFile&)> set(const char* pointer, const Json& value) {
    return [=](GltfFile& file) { file.json[Json::json_pointer(pointer)] = value; };
}

class Refused : public testing::TestWithParam<Row> {};

TEST_P(Refused, WithCodeAndPath) {
    GltfFile file = sound();
    ASSERT_TRUE(file.load());
    GetParam().damage(file);
    const auto scene = file.load();
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().code, GetParam().code) << toString(scene.error());
    EXPECT_TRUE(scene.error().where.ends_with(GetParam().where)) << toString(scene.error());
    EXPECT_FALSE(scene.error().what.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Index, Refused,
    testing::Values(
        Row{"position", set("/meshes/0/primitives/0/attributes/POSITION", 9), "gltf.index-range",
            "/meshes/0/primitives/0/attributes/POSITION"},
        Row{"negative", set("/meshes/0/primitives/0/attributes/POSITION", -7), "gltf.index-range",
            "/meshes/0/primitives/0/attributes/POSITION"},
        Row{"material", set("/meshes/0/primitives/0/material", 1), "gltf.index-range",
            "/meshes/0/primitives/0/material"},
        Row{"target", set("/meshes/0/primitives/0/targets", {{{"POSITION", 4}}}), "gltf.index-range",
            "/meshes/0/primitives/0/targets/0/POSITION"},
        Row{"texture", set("/materials/0/normalTexture/index", 2), "gltf.index-range",
            "/materials/0/normalTexture/index"},
        Row{"image", set("/textures/0/source", 3), "gltf.index-range", "/textures/0/source"},
        Row{"sampler", set("/textures/0/sampler", 0), "gltf.index-range", "/textures/0/sampler"},
        Row{"mesh", set("/nodes/0/mesh", 1), "gltf.index-range", "/nodes/0/mesh"},
        Row{"skin", set("/nodes/0/skin", 0), "gltf.index-range", "/nodes/0/skin"},
        Row{"camera", set("/nodes/0/camera", 0), "gltf.index-range", "/nodes/0/camera"},
        Row{"child", set("/nodes/0/children", {5}), "gltf.index-range", "/nodes/0/children/0"},
        Row{"light", set("/nodes/0/extensions/KHR_lights_punctual/light", 0), "gltf.index-range",
            "/nodes/0/extensions/KHR_lights_punctual/light"},
        Row{"scene", set("/scene", 1), "gltf.index-range", "/scene"},
        Row{"sceneNode", set("/scenes/0/nodes/0", 1), "gltf.index-range", "/scenes/0/nodes/0"},
        Row{"view", set("/accessors/0/bufferView", 8), "gltf.index-range", "/accessors/0/bufferView"},
        Row{"buffer", set("/bufferViews/0/buffer", 1), "gltf.index-range", "/bufferViews/0/buffer"},
        Row{"joint", set("/skins", {{{"joints", {3}}, {"inverseBindMatrices", 0}}}), "gltf.index-range",
            "/skins/0/joints/0"}),
    [](const auto& row) { return row.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Bounds, Refused,
    testing::Values(
        Row{"viewLength", set("/bufferViews/0/byteLength", 4000), "gltf.bounds", "/bufferViews/0"},
        Row{"viewOverflow", set("/bufferViews/0/byteOffset", 18446744073709551608ull), "gltf.bounds",
            "/bufferViews/0"},
        Row{"count", set("/accessors/0/count", 4), "gltf.bounds", "/accessors/0"},
        Row{"offset", set("/accessors/0/byteOffset", 4), "gltf.bounds", "/accessors/0"},
        Row{"offsetOverflow", set("/accessors/0/byteOffset", 18446744073709551612ull), "gltf.bounds",
            "/accessors/0"},
        Row{"stride", set("/bufferViews/0/byteStride", 16), "gltf.bounds", "/accessors/0"},
        Row{"sparseValues",
            set("/accessors/0/sparse", {{"count", 3},
                                        {"indices", {{"bufferView", 1}, {"componentType", 5123}}},
                                        {"values", {{"bufferView", 1}}}}),
            "gltf.bounds", "/accessors/0/sparse/values"},
        Row{"sparseNegative",
            set("/accessors/0/sparse",
                {{"count", 1},
                 {"indices", {{"bufferView", 1}, {"byteOffset", -4}, {"componentType", 5123}}},
                 {"values", {{"bufferView", 0}}}}),
            "gltf.value", "/accessors/0/sparse/indices/byteOffset"},
        Row{"hugeCount", set("/accessors/0/count", 4000000000u), "gltf.limit", "/accessors/0/count"},
        Row{"vertexIndex",
            [](GltfFile& file) {
                const int indices =
                    file.accessor("SCALAR", GltfFile::kUShort, std::vector<unsigned short>{0, 1, 3});
                file.json["meshes"][0]["primitives"][0]["indices"] = indices;
            },
            "gltf.vertex-range", "/meshes/0/primitives/0/indices"}),
    [](const auto& row) { return row.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Type, Refused,
    testing::Values(
        Row{"component", set("/accessors/0/componentType", 5130), "gltf.type", "/accessors/0/componentType"},
        Row{"noElements", set("/accessors/0/count", 0), "gltf.type", "/accessors/0/count"},
        Row{"positionType", set("/accessors/0/type", "VEC2"), "gltf.type", "/attributes/POSITION"},
        Row{"indexType", set("/accessors/1/componentType", 5122), "gltf.type", "/indices"},
        Row{"smallStride", [](GltfFile& file) { file.json["bufferViews"][0]["byteStride"] = 8; }, "gltf.type",
            "/accessors/0"},
        Row{"counts",
            [](GltfFile& file) {
                file.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] =
                    file.floats("VEC2", {0, 0, 1, 1});
            },
            "gltf.type", "/attributes/TEXCOORD_0"},
        Row{"matrix", set("/nodes/0/matrix", {1, 0, 0}), "gltf.schema", "/nodes/0/matrix"},
        Row{"emptySkin",
            [](GltfFile& file) {
                file.json["skins"] = {{{"joints", Json::array()}, {"inverseBindMatrices", 0}}};
                file.json["nodes"][0]["skin"] = 0;
            },
            "gltf.type", "/skins/0/joints"},
        Row{"inverseBind",
            [](GltfFile& file) {
                file.json["skins"] = {{{"joints", {0}}, {"inverseBindMatrices", 0}}};
                file.json["nodes"][0]["skin"] = 0;
            },
            "gltf.type", "/skins/0/inverseBindMatrices"}),
    [](const auto& row) { return row.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Value, Refused,
    testing::Values(
        Row{"mode", set("/meshes/0/primitives/0/mode", 7), "gltf.value", "/meshes/0/primitives/0/mode"},
        Row{"alphaMode", set("/materials/0/alphaMode", "GLASS"), "gltf.value", "/materials/0/alphaMode"},
        Row{"wrap",
            [](GltfFile& file) {
                file.json["samplers"] = {{{"wrapS", 1}}};
                file.json["textures"][0]["sampler"] = 0;
            },
            "gltf.value", "/samplers/0/wrapS"},
        Row{"magFilter",
            [](GltfFile& file) {
                file.json["samplers"] = {{{"magFilter", 9987}}};
                file.json["textures"][0]["sampler"] = 0;
            },
            "gltf.value", "/samplers/0/magFilter"},
        Row{"translation", set("/nodes/0/translation", {0, 1e300, 0}), "gltf.value", "/nodes/0/translation"},
        Row{"accumulated",
            [](GltfFile& file) {
                file.json["nodes"] = {{{"scale", {1e30, 1, 1}}, {"children", {1}}},
                                      {{"scale", {1e30, 1, 1}}}};
            },
            "gltf.value", "/nodes/1"},
        Row{"position",
            [](GltfFile& file) {
                file.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] =
                    file.floats("VEC3", {0, 0, 0, 1, INFINITY, 0, 0, 1, 0});
            },
            "gltf.value", "/accessors/2"}),
    [](const auto& row) { return row.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Tree, Refused,
    testing::Values(Row{"self", set("/nodes/0/children", {0}), "gltf.node-tree", "/nodes/0"},
                    Row{"cycle",
                        set("/nodes", {{{"children", {1}}}, {{"children", {2}}}, {{"children", {0}}}}),
                        "gltf.node-tree", "/nodes/0"},
                    Row{"twoParents",
                        set("/nodes", {{{"children", {2}}}, {{"children", {2}}}, Json::object()}),
                        "gltf.node-tree", "/nodes/2"}),
    [](const auto& row) { return row.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Document, Refused,
    testing::Values(Row{"version", set("/asset/version", "1.0"), "gltf.version", "/asset/version"},
                    Row{"noVersion", set("/asset", Json::object()), "gltf.version", "/asset/version"},
                    Row{"extension",
                        set("/extensionsRequired", {"KHR_texture_transform", "KHR_draco_mesh_compression"}),
                        "gltf.extension", "/extensionsRequired/1"},
                    Row{"depth",
                        [](GltfFile& file) {
                            Json deep;
                            for (int i = 0; i < 100; ++i)
                                deep = Json::array({deep});
                            file.json["extras"] = deep;
                        },
                        "gltf.limit", "the JSON"}),
    [](const auto& row) { return row.param.name; });

TEST(GltfRefused, UnknownExtensionIsNamed) {
    GltfFile file = sound();
    file.json["extensionsRequired"] = {"KHR_texture_basisu"};
    const auto scene = file.load();
    ASSERT_FALSE(scene);
    EXPECT_NE(scene.error().what.find("KHR_texture_basisu"), std::string::npos);
}

TEST(GltfRefused, OptionalExtensionsAreWarnedOfOnceEach) {
    GltfFile file = sound();
    file.json["extensionsUsed"] = {"KHR_materials_clearcoat", "KHR_materials_unlit", "VENDOR_odd"};
    ASSERT_TRUE(file.load());
    EXPECT_EQ(file.warnings.size(), 3u); // these two, and the missing UV stream of the normal map
}

// Memory is counted over all meshes, even where they share their accessors.
TEST(GltfRefused, MemoryIsCounted) {
    GltfFile file = sound();
    franken::LoadOptions options;
    options.maxMemoryBytes = 1 << 20;
    EXPECT_TRUE(file.load(options));
    const Json primitive = file.json["meshes"][0]["primitives"][0];
    for (int i = 0; i < 400; ++i)
        file.json["meshes"][0]["primitives"].push_back(primitive);
    EXPECT_EQ(file.load(options).error().code, "gltf.limit");
    EXPECT_TRUE(file.load());
}

TEST(GltfRefused, OnlyFilesInTheFolderAreRead) {
    const std::filesystem::path folder = franken::test::emptyTestFolder();
    std::filesystem::create_directories(folder / "model/a b");
    const std::vector<float> points{0, 0, 0, 1, 0, 0, 0, 1, 0};
    for (const char* name : {"outside.bin", "model/inside.bin", "model/a b/spaced.bin"})
        std::ofstream(folder / name, std::ios::binary)
            .write(reinterpret_cast<const char*>(points.data()),
                   static_cast<std::streamsize>(points.size() * 4));
    GltfFile file;
    file.setTriangle();
    const auto load = [&](const std::string& uri) {
        file.json["buffers"] = {{{"byteLength", 36}, {"uri", uri}}};
        std::ofstream(folder / "model/model.gltf") << file.json.dump();
        return franken::loadGltf(folder / "model/model.gltf");
    };
    for (const char* uri :
         {"inside.bin", "./inside.bin", "a%20b/spaced.bin", "a b/spaced.bin", "a%20b/../inside.bin",
          "a b\\spaced.bin", "not/there/../../inside.bin", ".\\a%20b\\..\\inside.bin"})
        EXPECT_TRUE(load(uri)) << uri;
    for (const std::string& uri :
         {std::string("../outside.bin"), std::string("%2E%2E/outside.bin"),
          std::string("a b/../../outside.bin"), std::string("..\\outside.bin"),
          std::string("../model/inside.bin"), (folder / "outside.bin").string(),
          "file://" + (folder / "outside.bin").string(), std::string("http://localhost/inside.bin"),
          std::string("missing.bin"), std::string("inside.bin%00x")}) {
        const auto scene = load(uri);
        ASSERT_FALSE(scene) << uri;
        EXPECT_EQ(scene.error().code, "gltf.buffer") << uri;
    }
}

TEST(GltfRefused, NoFileAndNoGltf) {
    EXPECT_EQ(franken::loadGltf("/nonexistent.gltf").error().code, "gltf.file");
    EXPECT_EQ(franken::loadGltf(std::filesystem::temp_directory_path()).error().code, "gltf.file");
    const std::filesystem::path path = franken::test::testFolder() / "text.gltf";
    for (const char* text : {"", "{", "[]", "not JSON", "glTF"}) {
        std::ofstream(path) << text;
        const auto scene = franken::loadGltf(path);
        ASSERT_FALSE(scene) << text;
        EXPECT_TRUE(scene.error().code == "gltf.json" || scene.error().code == "gltf.container") << text;
    }
}

// A .glb that is cut at any byte is refused, or was complete.
TEST(GltfRefused, CutContainers) {
    GltfFile file = sound();
    const std::filesystem::path path = file.write(true);
    std::ifstream stream(path, std::ios::binary);
    const std::string whole((std::istreambuf_iterator<char>(stream)), {});
    for (std::size_t length = 0; length < whole.size(); length += length < 64 ? 1 : 37) {
        std::ofstream(path, std::ios::binary) << whole.substr(0, length);
        EXPECT_FALSE(franken::loadGltf(path)) << length;
    }
    std::filesystem::remove(path);
}

// Lengths in the headers that do not fit the file.
TEST(GltfRefused, LyingContainers) {
    GltfFile file = sound();
    const std::filesystem::path path = file.write(true);
    std::ifstream stream(path, std::ios::binary);
    const std::string whole((std::istreambuf_iterator<char>(stream)), {});
    const std::size_t binHeader =
        20 + static_cast<unsigned char>(whole[12]) + 256u * static_cast<unsigned char>(whole[13]);
    for (const std::size_t field : {std::size_t{12}, binHeader})
        for (const int byte : {0x01, 0x7F, 0xFF}) {
            std::string lying = whole;
            lying[field + 3] = static_cast<char>(byte);
            std::ofstream(path, std::ios::binary) << lying;
            const auto scene = franken::loadGltf(path);
            ASSERT_FALSE(scene) << field;
            EXPECT_EQ(scene.error().code, "gltf.container") << field;
        }
    std::filesystem::remove(path);
}

} // namespace
