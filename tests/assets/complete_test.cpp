// SPDX-License-Identifier: MIT
// Scenes made by code: what is filled in, and the shapes.
#include "franken/complete.h"
#include "franken/scene_check.h"
#include "franken/tangents.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <limits>

namespace franken::test {
namespace {

Scene sceneOf(Primitive primitive) {
    Scene scene;
    scene.meshes = {{"", {std::move(primitive)}}};
    scene.instances = {{.name = ""}};
    return scene;
}

/// Positions alone: two triangles with a fold between them.
Primitive fold() {
    Primitive primitive;
    primitive.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
    primitive.indices = {0, 1, 2, 0, 3, 1};
    return primitive;
}

TEST(Complete, NeedsPositionsAlone) {
    const Result<Scene> scene = complete(sceneOf(fold()));
    ASSERT_TRUE(scene) << toString(scene.error());
    EXPECT_TRUE(check(*scene));
    ASSERT_EQ(scene->materials.size(), 1u);
    EXPECT_EQ(scene->materials[0].factors.metallic, 1) << "glTF's default";
    const Primitive& primitive = scene->meshes[0].primitives[0];
    ASSERT_EQ(primitive.positions.size(), 6u) << "flat: no vertex is shared";
    EXPECT_EQ(primitive.normals[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(primitive.normals[3], glm::vec3(0, -1, 0)) << "of (0, 0, -1) x (1, 0, 0)";
    EXPECT_EQ(primitive.bounds.min, glm::dvec3(0, 0, -1));
    EXPECT_EQ(primitive.bounds.max, glm::dvec3(1, 1, 0));
}

TEST(Complete, CountsVerticesWhereThereAreNoIndices) {
    Primitive primitive = fold();
    primitive.indices.clear();
    const Result<Scene> refused = complete(sceneOf(primitive));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().where, "meshes[0].primitives[0].indices") << "four make no triangles";
    primitive.positions.pop_back();
    EXPECT_EQ(complete(sceneOf(primitive))->meshes[0].primitives[0].indices,
              (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(Complete, TurnsTrianglesToTheirNormalsAndMirroredInstances) {
    Primitive primitive = fold();
    primitive.indices = {0, 2, 1};
    primitive.normals.assign(4, {0, 0, 3});
    Scene scene = sceneOf(primitive);
    scene.instances.push_back({.name = "", .world = glm::scale(glm::dmat4(1), {1, -2, 1})});
    const Result<Scene> done = complete(scene);
    ASSERT_TRUE(done);
    EXPECT_EQ(done->meshes[0].primitives[0].indices, (std::vector<std::uint32_t>{0, 1, 2}));
    EXPECT_EQ(done->meshes[0].primitives[0].normals[2], glm::vec3(0, 0, 1));
    EXPECT_FALSE(done->instances[0].mirrored);
    EXPECT_TRUE(done->instances[1].mirrored);
    scene.instances[1].world = glm::scale(glm::dmat4(1), {0.01, 0.01, -0.01});
    EXPECT_TRUE(complete(scene)->instances[1].mirrored) << "however small";
}

TEST(Complete, LeavesATriangleThatOneNormalLeansAwayFrom) {
    Primitive primitive = fold();
    primitive.indices = {0, 1, 2};
    primitive.normals = {{0, 0, 1}, {1, 0, -0.1f}, {0, 0, 1}, {0, 0, 1}};
    EXPECT_EQ(complete(sceneOf(primitive))->meshes[0].primitives[0].indices,
              (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(Complete, ComputesTangentsForANormalTextureAlone) {
    Primitive primitive = plane({2, 2});
    primitive.tangents.clear();
    Scene scene = sceneOf(primitive);
    scene.images = {{"", 1, 1, {128, 128, 255, 255}}};
    scene.textures.emplace_back().image = 0;
    scene.materials.resize(2);
    EXPECT_TRUE(complete(scene)->meshes[0].primitives[0].tangents.empty());
    scene.materials[0].textures[TextureRole::Normal].texture = 0;
    const Result<Scene> done = complete(scene);
    ASSERT_TRUE(done);
    for (const glm::vec4& tangent : done->meshes[0].primitives[0].tangents)
        EXPECT_EQ(tangent, glm::vec4(1, 0, 0, 1));
    scene.meshes[0].primitives[0].tangents.assign(4, {0, 1, 0, -1});
    EXPECT_EQ(complete(scene)->meshes[0].primitives[0].tangents, std::vector(4, glm::vec4(0, 1, 0, -1)))
        << "those that are there stay";
    EXPECT_EQ(done->materials.size(), 2u);
    scene.meshes[0].primitives[0].material = kNone;
    EXPECT_EQ(complete(scene)->meshes[0].primitives[0].material, 2);
}

// A vertex has one tangent: by the first of its materials, the variants' among them, that has a normal
// texture.
TEST(Complete, ComputesTangentsForTheMaterialsOfVariantsToo) {
    Primitive primitive = plane({2, 2});
    primitive.tangents.clear();
    primitive.uv[1] = primitive.uv[0];
    for (glm::vec2& uv : primitive.uv[1])
        uv = {uv.y, uv.x};
    primitive.variantMaterials = {kNone, 1, 2};
    Scene scene = sceneOf(primitive);
    scene.variants = {"plain", "bumpy", "turned"};
    scene.images = {{"", 1, 1, {128, 128, 255, 255}}};
    scene.textures.emplace_back().image = 0;
    scene.materials.resize(3);
    EXPECT_TRUE(complete(scene)->meshes[0].primitives[0].tangents.empty());
    const auto tangentOf = [](const Scene& from) {
        const Result<Scene> done = complete(from);
        EXPECT_TRUE(done);
        return done->meshes[0].primitives[0].tangents.at(0);
    };
    scene.materials[2].textures[TextureRole::Normal] = {.texture = 0, .uvSet = 1};
    EXPECT_EQ(tangentOf(scene), glm::vec4(0, -1, 0, -1)) << "u grows downwards in the second stream";
    scene.materials[1].textures[TextureRole::Normal].texture = 0;
    EXPECT_EQ(tangentOf(scene), glm::vec4(1, 0, 0, 1)) << "the first one counts";
}

/// Corners of a cube, six faces of two triangles, and each corner shared by all that meet there.
Primitive cube() {
    Primitive primitive;
    for (int i = 0; i < 8; ++i)
        primitive.positions.emplace_back(i & 1, i >> 1 & 1, i >> 2);
    primitive.indices = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                         2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
    return primitive;
}

TEST(Complete, SmoothNormalsAreTheMeanOfTheTrianglesByTheirAngles) {
    const Result<Scene> scene = complete(sceneOf(cube()), Normals::Smooth);
    ASSERT_TRUE(scene);
    const Primitive& primitive = scene->meshes[0].primitives[0];
    ASSERT_EQ(primitive.positions.size(), 8u) << "vertices stay shared";
    EXPECT_EQ(primitive.indices, cube().indices);
    for (std::size_t i = 0; i < 8; ++i)
        EXPECT_LT(
            glm::distance(primitive.normals[i], glm::normalize(2.0f * primitive.positions[i] - glm::vec3(1))),
            1e-6f)
            << i << ": three faces count alike, however they are cut into triangles";
    EXPECT_EQ(complete(sceneOf(cube()))->meshes[0].primitives[0].positions.size(), 36u);

    Primitive given = cube();
    given.normals.assign(8, {0, 0, 1});
    given.indices.resize(3);
    EXPECT_EQ(complete(sceneOf(given), Normals::Smooth)->meshes[0].primitives[0].normals[0],
              glm::vec3(0, 0, 1))
        << "those that are there stay";
}

TEST(Complete, SmoothNormalsOfASphereAreItsRadiiAcrossTheSeam) {
    Primitive ball = sphere(2, 24);
    ball.normals.clear();
    ball.tangents.clear();
    const Result<Scene> scene = complete(sceneOf(ball), Normals::Smooth);
    ASSERT_TRUE(scene);
    const Primitive& primitive = scene->meshes[0].primitives[0];
    ASSERT_EQ(primitive.positions.size(), ball.positions.size());
    for (std::size_t i = 0; i < primitive.positions.size(); ++i)
        EXPECT_LT(glm::distance(primitive.normals[i], primitive.positions[i] / 2.0f), 0.01f) << i;
    for (std::size_t row = 0; row <= 24; ++row)
        EXPECT_EQ(ball.positions[49 * row], ball.positions[49 * row + 48]) << "the seam closes";
}

TEST(Complete, SmoothNormalsOfWhatHasNoSideAreZ) {
    Primitive primitive;
    primitive.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0},      {0, 3, 0},
                           {0, 0, 3}, {9, 9, 9}, {1e-30f, 0, 0}, {0, 0, 1e-30f}};
    primitive.indices = {0, 1, 2, /* both sides: */ 0, 3, 4, 0, 4, 3, /* tiny: */ 0, 7, 6};
    const Result<Scene> scene = complete(sceneOf(primitive), Normals::Smooth);
    ASSERT_TRUE(scene) << toString(scene.error());
    const std::vector<glm::vec3>& normals = scene->meshes[0].primitives[0].normals;
    for (const std::size_t vertex : {1u, 2u, 3u, 4u, 5u})
        EXPECT_EQ(normals[vertex], glm::vec3(0, 0, 1)) << vertex;
    EXPECT_EQ(normals[6], glm::vec3(0, 1, 0)) << "of the tiny one";
}

TEST(Complete, NamesWhatIsWrong) {
    const auto whereOf = [](const Scene& scene) {
        const Result<Scene> done = complete(scene);
        return done ? std::string() : done.error().code + " " + done.error().where;
    };
    const std::string at = "scene.data meshes[0].primitives[0]";
    Primitive primitive = fold();
    primitive.indices[2] = 9;
    EXPECT_EQ(whereOf(sceneOf(primitive)), at + ".indices");
    primitive = fold();
    primitive.positions[1].x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(whereOf(sceneOf(primitive)), at + ".positions");
    primitive = fold();
    primitive.uv[0] = {{0, 0}};
    EXPECT_EQ(whereOf(sceneOf(primitive)), at + ".uv[0]");
    primitive = fold();
    primitive.normals.assign(4, {0, 0, 0});
    EXPECT_EQ(whereOf(sceneOf(primitive)), at + ".normals");
    primitive = fold();
    primitive.material = 3;
    EXPECT_EQ(whereOf(sceneOf(primitive)), at + ".material");
    EXPECT_EQ(whereOf(sceneOf(plane({std::numeric_limits<float>::infinity(), 1}))), at + ".positions");
    EXPECT_EQ(whereOf({}), "");
}

/// The area of all triangles; each must have one, and face where its normals do.
double areaOf(const Primitive& primitive) {
    double area = 0;
    for (std::size_t i = 0; i < primitive.indices.size(); i += 3) {
        const auto at = [&](std::size_t n) {
            return glm::dvec3(primitive.positions[primitive.indices[i + n]]);
        };
        const glm::dvec3 front = glm::cross(at(1) - at(0), at(2) - at(0));
        EXPECT_GT(glm::length(front), 0);
        for (std::size_t n = 0; n < 3; ++n) {
            EXPECT_GT(glm::dot(front, glm::dvec3(primitive.normals[primitive.indices[i + n]])), 0);
        }
        area += 0.5 * glm::length(front);
    }
    return area;
}

/// Tangents as computeTangents() makes them: on a sphere at the seam, where it sees one side alone, but for
/// half a column, and not at the poles, where any do.
void expectTangents(const Primitive& primitive, float tolerance) {
    Primitive computed = primitive;
    computeTangents(computed, primitive.uv[0]);
    for (std::size_t i = 0; i < primitive.tangents.size(); ++i) {
        if (std::abs(primitive.normals[i].y) > 0.99f && tolerance > 0.01f)
            continue;
        EXPECT_LT(glm::distance(glm::vec3(primitive.tangents[i]), glm::vec3(computed.tangents[i])),
                  tolerance);
        EXPECT_EQ(primitive.tangents[i].w, computed.tangents[i].w);
    }
}

TEST(Shapes, HaveTheirAreaAndAllThatLightNeeds) {
    EXPECT_NEAR(areaOf(plane({3, 2})), 6, 1e-6);
    EXPECT_NEAR(areaOf(box({1, -2, 3})), 2 * (2 + 3 + 6), 1e-6);
    EXPECT_NEAR(areaOf(sphere(2, 64)), 4 * 3.14159265 * 4, 0.1);
    EXPECT_EQ(box({1, 2, 3}).indices.size(), 36u);
    EXPECT_EQ(box({1, 2, 3}).bounds.max, glm::dvec3(0.5, 1, 1.5));
    for (int column = 0; column < 8; ++column)
        EXPECT_EQ(sphere(1, 4).positions.rbegin()[column], glm::vec3(0, -1, 0)) << "a pole is one point";
    EXPECT_EQ(sphere(1, -5).indices.size(), 3u * 8) << "2 rings, of triangles at the poles";
    for (const Primitive& shape : {plane({1, 2}), box({1, 2, 3}), sphere(0.5f, 24)}) {
        EXPECT_TRUE(check(*complete(sceneOf(shape))));
        expectTangents(shape, shape.positions.size() > 100 ? 0.07f : 1e-6f);
    }
}

} // namespace
} // namespace franken::test
