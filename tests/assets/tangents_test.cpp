// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "franken/tangents.h"
#include "gltf_file.h"

namespace {

using franken::Primitive;

/// A flat strip of quads in the xy plane, normals +Z, whose u runs right and then, mirrored, left again.
Primitive mirroredQuads() {
    Primitive primitive;
    primitive.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
    primitive.normals.assign(6, {0, 0, 1});
    primitive.uv[0] = {{0, 1}, {1, 1}, {0, 1}, {0, 0}, {1, 0}, {0, 0}}; // v downwards
    primitive.indices = {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4};
    return primitive;
}

TEST(Tangents, OfAFlatQuad) {
    Primitive primitive = mirroredQuads();
    primitive.indices.resize(6);
    franken::computeTangents(primitive, primitive.uv[0]);
    EXPECT_EQ(primitive.positions.size(), 6u);
    for (const std::uint32_t index : primitive.indices)
        EXPECT_EQ(primitive.tangents[index], glm::vec4(1, 0, 0, 1)); // B = N x T = +Y, up in the image
}

TEST(Tangents, MirroredUvsAreSplit) {
    Primitive primitive = mirroredQuads();
    franken::computeTangents(primitive, primitive.uv[0]);
    ASSERT_EQ(primitive.positions.size(), 8u) << "the two vertices of the seam have copies";
    ASSERT_EQ(primitive.tangents.size(), 8u);
    ASSERT_EQ(primitive.uv[0].size(), 8u);
    for (std::size_t i = 0; i < primitive.indices.size(); ++i)
        EXPECT_EQ(primitive.tangents[primitive.indices[i]],
                  i < 6 ? glm::vec4(1, 0, 0, 1) : glm::vec4(-1, 0, 0, -1));
    EXPECT_EQ(primitive.positions[primitive.indices[6]], glm::vec3(1, 0, 0));
}

TEST(Tangents, EqualVerticesCountAsOne) {
    // A roof of two sloping quads with smooth normals on the ridge, once indexed, once with all vertices
    // apart.
    Primitive shared;
    shared.positions = {{-1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 2}, {0, 1, 2}, {1, 0, 2}};
    const glm::vec3 left = glm::normalize(glm::vec3(-1, 1, 0)), right = glm::normalize(glm::vec3(1, 1, 0));
    shared.normals = {left, {0, 1, 0}, right, left, {0, 1, 0}, right};
    shared.uv[0] = {{0, 0}, {1, 0}, {2, 0}, {0, 2}, {1, 2}, {2, 2}};
    shared.indices = {0, 3, 4, 0, 4, 1, 1, 4, 5, 1, 5, 2};
    Primitive apart;
    for (const std::uint32_t index : shared.indices) {
        apart.positions.push_back(shared.positions[index]);
        apart.normals.push_back(shared.normals[index]);
        apart.uv[0].push_back(shared.uv[0][index]);
        apart.indices.push_back(static_cast<std::uint32_t>(apart.indices.size()));
    }
    franken::computeTangents(shared, shared.uv[0]);
    franken::computeTangents(apart, apart.uv[0]);
    for (std::size_t i = 0; i < shared.indices.size(); ++i)
        EXPECT_EQ(shared.tangents[shared.indices[i]], apart.tangents[apart.indices[i]]) << i;
    EXPECT_LE(glm::length(glm::vec3(shared.tangents[1]) - glm::vec3(1, 0, 0)), 1e-6f)
        << "the ridge is smooth";
}

TEST(Tangents, AreFiniteWhereNothingIsKnown) {
    Primitive primitive = mirroredQuads();
    primitive.uv[0].assign(6, {0.5f, 0.5f});                      // no direction at all
    primitive.indices.insert(primitive.indices.end(), {2, 2, 2}); // no area either
    franken::computeTangents(primitive, primitive.uv[0]);
    for (std::size_t i = 0; i < primitive.tangents.size(); ++i) {
        EXPECT_NEAR(glm::length(glm::vec3(primitive.tangents[i])), 1, 1e-6);
        EXPECT_NEAR(glm::dot(glm::vec3(primitive.tangents[i]), primitive.normals[i]), 0, 1e-6);
        EXPECT_EQ(std::fabs(primitive.tangents[i].w), 1);
    }
}

TEST(Tangents, FollowTheTextureTransform) {
    GltfFile file;
    file.json["extensionsUsed"] = {"KHR_texture_transform"};
    const GltfFile::Json use{{"index", file.appendTexture()},
                             {"extensions", {{"KHR_texture_transform", {{"rotation", 1.57079632679}}}}}};
    file.setPrimitive({{"attributes",
                        {{"POSITION", file.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0})},
                         {"NORMAL", file.floats("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1})},
                         {"TEXCOORD_0", file.floats("VEC2", {0, 1, 1, 1, 0, 0})}}},
                       {"material", 0}});
    file.json["materials"] = {{{"normalTexture", use}}};
    const franken::Scene scene = file.loaded();
    ASSERT_EQ(scene.meshes[0].primitives[0].tangents.size(), 3u);
    // u' = v: it grows downwards on the triangle.
    EXPECT_LE(glm::length(scene.meshes[0].primitives[0].tangents[0] - glm::vec4(0, -1, 0, 1)), 1e-6f);
}

struct Difference {
    std::vector<double> degrees;
    std::size_t flipped = 0;
};

/// Computed tangents against the file's own, corner by corner.
void compare(const Primitive& own, const franken::TextureRef& map, Difference& difference) {
    Primitive computed = own;
    std::vector<glm::vec2> uv = own.uv[map.uvSet];
    for (glm::vec2& point : uv)
        point = glm::vec2(map.transform * glm::vec3(point, 1));
    franken::computeTangents(computed, uv);
    for (std::size_t i = 0; i < own.indices.size(); ++i) {
        const glm::vec4 a = own.tangents[own.indices[i]], b = computed.tangents[computed.indices[i]];
        const double cosine = glm::dot(glm::dvec3(a), glm::dvec3(b)) / glm::length(glm::dvec3(a));
        difference.degrees.push_back(glm::degrees(std::acos(std::clamp(cosine, -1.0, 1.0))));
        difference.flipped += a.w != b.w;
    }
}

TEST(Tangents, AgreeWithThoseOfOthers) {
    const auto folder = sharedFolder() / "assets/valid";
    std::vector<std::filesystem::path> files = gltfFilesBelow(folder);
    const auto more = gltfFilesBelow("/usr/share/assimp/models/glTF2");
    files.insert(files.end(), more.begin(), more.end());
    if (files.empty())
        GTEST_SKIP() << "no models of others in " << folder;
    for (const auto& path : files) {
        const auto scene = franken::loadGltf(path);
        if (!scene || scene->meshes.empty())
            continue;
        Difference difference;
        for (const auto& mesh : scene->meshes)
            for (const Primitive& primitive : mesh.primitives) {
                const auto& map = scene->materials[static_cast<std::size_t>(primitive.material)]
                                      .textures[franken::TextureRole::Normal];
                if (map && !primitive.tangents.empty())
                    compare(primitive, map, difference);
            }
        if (difference.degrees.empty())
            continue;
        std::sort(difference.degrees.begin(), difference.degrees.end());
        const auto percentile = [&](double p) {
            return difference
                .degrees[static_cast<std::size_t>(p * static_cast<double>(difference.degrees.size() - 1))];
        };
        std::cout << path.filename().string() << ": " << difference.degrees.size() << " corners, median "
                  << percentile(0.5) << ", 98.5 % " << percentile(0.985) << ", max " << percentile(1)
                  << " degrees, " << difference.flipped << " of other handedness\n";
        // What is left is WaterBottle's: a ring of triangles whose UVs have no area, where any tangent will
        // do.
        EXPECT_LE(percentile(0.985), 0.1) << path;
        EXPECT_LE(difference.flipped * 100, difference.degrees.size()) << path;
    }
}

} // namespace
