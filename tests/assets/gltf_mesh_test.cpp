// SPDX-License-Identifier: MIT
// Vertices and indices: every way in which glTF can store them comes out in the one form of Primitive.
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "gltf_file.h"

namespace {

using franken::Primitive;
using franken::Scene;
using Json = GltfFile::Json;
using Indices = std::vector<std::uint32_t>;

const std::vector<float> kSquare = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
const std::vector<glm::vec3> kSquarePoints = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};

/// A square with normals, so that its vertices stay as they are.
Json square(GltfFile& file) {
    const int normals = file.floats("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    return {{"attributes", {{"POSITION", file.floats("VEC3", kSquare)}, {"NORMAL", normals}}}};
}

Primitive onlyPrimitive(GltfFile& file) {
    Scene scene = file.loaded();
    if (scene.meshes.size() != 1 || scene.meshes[0].primitives.size() != 1) {
        ADD_FAILURE() << "one primitive is expected";
        return {};
    }
    return std::move(scene.meshes[0].primitives[0]);
}

struct ModeRow {
    const char* name;
    int mode;
    Indices indices; ///< Empty: not indexed.
    Indices triangles;
};

class Modes : public testing::TestWithParam<ModeRow> {};

TEST_P(Modes, BecomeLists) {
    GltfFile file;
    Json primitive = square(file);
    primitive["mode"] = GetParam().mode;
    if (!GetParam().indices.empty())
        primitive["indices"] = file.accessor("SCALAR", GltfFile::kUInt, GetParam().indices);
    file.setPrimitive(primitive);
    EXPECT_EQ(onlyPrimitive(file).indices, GetParam().triangles);
}

INSTANTIATE_TEST_SUITE_P(, Modes,
                         testing::Values(ModeRow{"list", 4, {0, 1, 2, 2, 1, 3}, {0, 1, 2, 2, 1, 3}},
                                         ModeRow{"listWithRest", 4, {0, 1, 2, 2, 1}, {0, 1, 2}},
                                         ModeRow{"listPlain", 4, {}, {0, 1, 2}},
                                         ModeRow{"strip", 5, {0, 1, 2, 3}, {0, 1, 2, 1, 3, 2}},
                                         ModeRow{"stripPlain", 5, {}, {0, 1, 2, 1, 3, 2}},
                                         ModeRow{"fan", 6, {0, 1, 3, 2}, {1, 3, 0, 3, 2, 0}},
                                         ModeRow{"fanPlain", 6, {}, {1, 2, 0, 2, 3, 0}}),
                         [](const auto& row) { return row.param.name; });

TEST(GltfMesh, IndicesOfEachWidth) {
    for (const int type : {GltfFile::kUByte, GltfFile::kUShort, GltfFile::kUInt}) {
        GltfFile file;
        Json primitive = square(file);
        if (type == GltfFile::kUByte)
            primitive["indices"] = file.accessor("SCALAR", type, std::vector<std::uint8_t>{2, 1, 3});
        if (type == GltfFile::kUShort)
            primitive["indices"] = file.accessor("SCALAR", type, std::vector<std::uint16_t>{2, 1, 3});
        if (type == GltfFile::kUInt)
            primitive["indices"] = file.accessor("SCALAR", type, Indices{2, 1, 3});
        file.setPrimitive(primitive);
        EXPECT_EQ(onlyPrimitive(file).indices, (Indices{2, 1, 3})) << type;
    }
}

TEST(GltfMesh, Interleaved) {
    GltfFile file;
    std::vector<float> data; // position, normal, uv: 32 bytes a vertex
    for (std::size_t i = 0; i < 4; ++i)
        data.insert(data.end(), {kSquare[3 * i], kSquare[3 * i + 1], kSquare[3 * i + 2], 0, 0, 1,
                                 static_cast<float>(i), 0.5f});
    const int view = file.view(data, 32);
    const auto accessor = [&](const char* type, int offset) {
        return file.append("accessors", {{"bufferView", view},
                                         {"byteOffset", offset},
                                         {"componentType", GltfFile::kFloat},
                                         {"count", 4},
                                         {"type", type}});
    };
    const int positions = accessor("VEC3", 0), normals = accessor("VEC3", 12), uv = accessor("VEC2", 24);
    file.setPrimitive(
        {{"attributes", {{"POSITION", positions}, {"NORMAL", normals}, {"TEXCOORD_0", uv}}}, {"mode", 5}});
    const Primitive primitive = onlyPrimitive(file);
    EXPECT_EQ(primitive.positions, kSquarePoints);
    EXPECT_EQ(primitive.normals, std::vector<glm::vec3>(4, {0, 0, 1}));
    EXPECT_EQ(primitive.uv[0], (std::vector<glm::vec2>{{0, 0.5f}, {1, 0.5f}, {2, 0.5f}, {3, 0.5f}}));
}

TEST(GltfMesh, SparseWithAndWithoutBase) {
    for (const bool hasBase : {true, false}) {
        GltfFile file;
        Json primitive = square(file);
        Json& accessor = file.json["accessors"][1]; // the positions; the normals came first
        ASSERT_EQ(accessor["count"], 4);
        const int indices = file.view(std::vector<std::uint8_t>{1, 3});
        const int values = file.view(std::vector<float>{5, 6, 7, 8, 9, 10});
        Json& positions = file.json["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
        positions["sparse"] = {{"count", 2},
                               {"indices", {{"bufferView", indices}, {"componentType", GltfFile::kUByte}}},
                               {"values", {{"bufferView", values}}}};
        if (!hasBase)
            positions.erase("bufferView");
        file.setPrimitive(primitive);
        const glm::vec3 base = hasBase ? kSquarePoints[2] : glm::vec3(0);
        EXPECT_EQ(onlyPrimitive(file).positions,
                  (std::vector<glm::vec3>{{0, 0, 0}, {5, 6, 7}, base, {8, 9, 10}}));
    }
}

TEST(GltfMesh, SparseIndices) {
    GltfFile file;
    Json primitive = square(file);
    primitive["indices"] = file.accessor("SCALAR", GltfFile::kUShort, std::vector<std::uint16_t>{0, 0, 0});
    const int indices = file.view(std::vector<std::uint16_t>{1, 2});
    const int values = file.view(std::vector<std::uint16_t>{1, 3});
    file.json["accessors"][primitive["indices"].get<std::size_t>()]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", indices}, {"componentType", GltfFile::kUShort}}},
        {"values", {{"bufferView", values}}}};
    file.setPrimitive(primitive);
    EXPECT_EQ(onlyPrimitive(file).indices, (Indices{0, 1, 3}));
}

// Both lie in one buffer view, each behind bytes of something else: as exporters pack them.
TEST(GltfMesh, SparseIndicesAndValuesBeginWhereTheySay) {
    GltfFile file;
    Json primitive = square(file);
    const int indices = file.view(std::vector<std::uint16_t>{2, 2, 2, 2, 1, 3}); // From the fifth.
    const int values = file.view(std::vector<float>{-1, -1, -1, 5, 6, 7, 8, 9, 10});
    Json& positions = file.json["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
    positions["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", indices}, {"byteOffset", 8}, {"componentType", GltfFile::kUShort}}},
        {"values", {{"bufferView", values}, {"byteOffset", 12}}}};
    file.setPrimitive(primitive);
    EXPECT_EQ(onlyPrimitive(file).positions,
              (std::vector<glm::vec3>{{0, 0, 0}, {5, 6, 7}, {0, 1, 0}, {8, 9, 10}}));
}

// An accessor's own offset, in a view that has another accessor's bytes first.
TEST(GltfMesh, IndicesBeginWhereTheySay) {
    GltfFile file;
    Json primitive = square(file);
    const int view = file.view(std::vector<std::uint16_t>{9, 9, 2, 1, 3});
    primitive["indices"] = file.append("accessors", {{"bufferView", view},
                                                     {"byteOffset", 4},
                                                     {"componentType", GltfFile::kUShort},
                                                     {"count", 3},
                                                     {"type", "SCALAR"}});
    file.setPrimitive(primitive);
    EXPECT_EQ(onlyPrimitive(file).indices, (Indices{2, 1, 3}));
}

TEST(GltfMesh, NormalizedIntegersAreFractions) {
    GltfFile file;
    Json primitive = square(file);
    primitive["attributes"]["TEXCOORD_0"] = file.accessor(
        "VEC2", GltfFile::kUShort, std::vector<std::uint16_t>{0, 65535, 0, 0, 0, 0, 0, 0}, true);
    primitive["attributes"]["TEXCOORD_1"] =
        file.accessor("VEC2", GltfFile::kFloat, std::vector<float>{0.25f, -3, 0, 0, 0, 0, 0, 0});
    // Rows of colours of three bytes are padded to four.
    const int view =
        file.view(std::vector<std::uint8_t>{255, 0, 51, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, 4);
    primitive["attributes"]["COLOR_0"] = file.append("accessors", {{"bufferView", view},
                                                                   {"componentType", GltfFile::kUByte},
                                                                   {"normalized", true},
                                                                   {"count", 4},
                                                                   {"type", "VEC3"}});
    file.setPrimitive(primitive);
    const Primitive loaded = onlyPrimitive(file);
    EXPECT_EQ(loaded.uv[0][0], glm::vec2(0, 1));
    EXPECT_EQ(loaded.uv[1][0], glm::vec2(0.25f, -3));
    EXPECT_EQ(loaded.colors[0], glm::vec4(1, 0, 0.2f, 1));
}

TEST(GltfMesh, Quantized) {
    GltfFile file;
    file.json["extensionsUsed"] = file.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    const int positions = file.accessor("VEC3", GltfFile::kShort,
                                        std::vector<std::int16_t>{0, 0, 0, 1000, 0, 0, 0, -32768, 0}, false);
    file.json["accessors"][0]["bufferView"] =
        file.view(std::vector<std::int16_t>{0, 0, 0, 0, 1000, 0, 0, 0, 0, -32768, 0, 0}, 8);
    const int normals = file.append(
        "accessors",
        {{"bufferView", file.view(std::vector<std::int8_t>{0, 0, 127, 0, 0, 0, -128, 0, 0, -127, 0, 0}, 4)},
         {"componentType", GltfFile::kByte},
         {"normalized", true},
         {"count", 3},
         {"type", "VEC3"}});
    file.setPrimitive({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}});
    const Primitive primitive = onlyPrimitive(file);
    EXPECT_EQ(primitive.positions, (std::vector<glm::vec3>{{0, 0, 0}, {1000, 0, 0}, {0, -32768, 0}}));
    EXPECT_EQ(primitive.normals, (std::vector<glm::vec3>{{0, 0, 1}, {0, 0, -1}, {0, -1, 0}}));
    EXPECT_EQ(primitive.bounds.min, glm::dvec3(0, -32768, 0));
    EXPECT_EQ(primitive.bounds.max, glm::dvec3(1000, 0, 0));
}

TEST(GltfMesh, MissingNormalsAreFlatAndTangentsOfTheFileAreIgnored) {
    GltfFile file;
    // Two triangles that share an edge and stand at a right angle.
    const int positions = file.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, -1});
    const int tangents = file.floats("VEC4", std::vector<float>(16, 1.0f));
    file.setPrimitive({{"attributes", {{"POSITION", positions}, {"TANGENT", tangents}}},
                       {"indices", file.accessor("SCALAR", GltfFile::kUInt, Indices{0, 1, 2, 0, 2, 3})}});
    const Primitive primitive = onlyPrimitive(file);
    EXPECT_EQ(primitive.indices, (Indices{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(primitive.positions[4], glm::vec3(0, 1, 0));
    EXPECT_EQ(primitive.normals,
              (std::vector<glm::vec3>{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {-1, 0, 0}, {-1, 0, 0}, {-1, 0, 0}}));
    EXPECT_TRUE(primitive.tangents.empty());
}

TEST(GltfMesh, TangentsOfTheFileAreKept) {
    GltfFile file;
    Json primitive = square(file);
    primitive["attributes"]["TANGENT"] =
        file.floats("VEC4", {2, 0, 0, 1, 0, 1, 0, -1, 1, 0, 0, 1, 1, 0, 0, 1});
    file.setPrimitive(primitive);
    const Primitive loaded = onlyPrimitive(file);
    EXPECT_EQ(loaded.tangents[0], glm::vec4(1, 0, 0, 1)); // made a unit vector
    EXPECT_EQ(loaded.tangents[1], glm::vec4(0, 1, 0, -1));
}

TEST(GltfMesh, PointsAndLinesAreLeftOutWithOneWarning) {
    GltfFile file;
    Json points = square(file), lines = points;
    points["mode"] = 0;
    lines["mode"] = 3;
    file.setPrimitive(square(file));
    file.json["meshes"][0]["primitives"].insert(file.json["meshes"][0]["primitives"].end(), {points, lines});
    EXPECT_EQ(file.loaded().meshes[0].primitives.size(), 1u);
    EXPECT_EQ(file.warnings.size(), 1u);
}

TEST(GltfMesh, AMeshOfNothingMakesNoInstance) {
    GltfFile file;
    file.setPrimitive({{"attributes", {{"NORMAL", file.floats("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1})}}}});
    const Scene scene = file.loaded();
    EXPECT_TRUE(scene.meshes.empty());
    EXPECT_TRUE(scene.instances.empty());
    EXPECT_EQ(file.warnings.size(), 1u);
}

} // namespace
