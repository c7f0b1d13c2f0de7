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
