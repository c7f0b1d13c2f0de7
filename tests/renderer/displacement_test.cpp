// SPDX-License-Identifier: MIT
#include "franken/displacement.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>

namespace franken::test {
namespace {

/// A square of 2 x 2 in the plane z = 0 that faces +Z, of so many quads along each side.
Primitive grid(int quads) {
    Primitive primitive;
    for (int row = 0; row <= quads; ++row)
        for (int column = 0; column <= quads; ++column) {
            const glm::vec2 uv = glm::vec2(column, row) / static_cast<float>(quads);
            primitive.positions.emplace_back(2 * uv.x - 1, 1 - 2 * uv.y, 0);
            primitive.normals.emplace_back(0, 0, 1);
            primitive.tangents.emplace_back(1, 0, 0, 1);
            primitive.uv[0].push_back(uv);
        }
    for (int row = 0; row < quads; ++row)
        for (int column = 0; column < quads; ++column) {
            const auto first = static_cast<std::uint32_t>(row * (quads + 1) + column);
            const std::uint32_t below = first + static_cast<std::uint32_t>(quads) + 1;
            primitive.indices.insert(primitive.indices.end(),
                                     {first, below, below + 1, first, below + 1, first + 1});
        }
    return primitive;
}

HeightMap ramp(float scale) {
    return {.image = paint(64, [](glm::vec2 uv) { return glm::vec4(uv.x); }),
            .scale = scale,
            .wrapS = Wrap::ClampToEdge,
            .wrapT = Wrap::ClampToEdge};
}

TEST(HeightAt, IsGlsLinearFilterWithItsWraps) {
    HeightMap map{.image = {"", 2, 1, {0, 9, 9, 9, 255, 9, 9, 9}}};
    EXPECT_FLOAT_EQ(heightAt(map, {0.25f, 0.5f}), 0);
    EXPECT_FLOAT_EQ(heightAt(map, {0.75f, 0.2f}), 1);
    EXPECT_FLOAT_EQ(heightAt(map, {0.5f, 0.5f}), 0.5f);
    EXPECT_FLOAT_EQ(heightAt(map, {0, 0.5f}), 0.5f) << "half of the last texel, which repeats";
    EXPECT_FLOAT_EQ(heightAt(map, {-1.25f, 0.5f}), 1);
    map.wrapS = Wrap::ClampToEdge;
    EXPECT_FLOAT_EQ(heightAt(map, {0, 0.5f}), 0);
    EXPECT_FLOAT_EQ(heightAt(map, {7, 0.5f}), 1);
    map.wrapS = Wrap::MirroredRepeat;
    EXPECT_FLOAT_EQ(heightAt(map, {1.25f, 0.5f}), 1);
    EXPECT_FLOAT_EQ(heightAt(map, {1.75f, 0.5f}), 0);
    EXPECT_FLOAT_EQ(heightAt(map, {-0.25f, 0.5f}), 0);
}

TEST(Displace, ARampGetsItsSlope) {
    Primitive primitive = grid(16);
    ASSERT_TRUE(displace(primitive, ramp(0.5f), primitive.uv[0]));
    // Height rises by 0.5 over the width 2: away from the clamped rim, dz/dx = 0.25.
    const glm::vec3 slope = glm::normalize(glm::vec3(-0.25f, 0, 1));
    for (std::size_t i = 0; i < primitive.positions.size(); ++i) {
        const float u = primitive.uv[0][i].x;
        if (u < 0.1f || u > 0.9f)
            continue;
        EXPECT_NEAR(primitive.positions[i].z, 0.5f * u, 0.002) << i;
        EXPECT_GT(glm::dot(primitive.normals[i], slope), 0.9999f) << i;
        EXPECT_GT(glm::dot(glm::vec3(primitive.tangents[i]), glm::normalize(glm::vec3(1, 0, 0.25f))),
                  0.9999f);
    }
    EXPECT_NEAR(primitive.bounds.max.z, 0.5f, 0.01f);
    EXPECT_NEAR(primitive.bounds.min.x, -1, 1e-6);
}

TEST(Displace, GroundAndScaleMoveAsTheySay) {
    Primitive up = grid(2), down = grid(2);
    HeightMap map{.image = paint(4, [](glm::vec2) { return glm::vec4(1); }), .scale = 3, .ground = 0.25f};
    ASSERT_TRUE(displace(up, map, up.uv[0]));
    map.scale = -3;
    ASSERT_TRUE(displace(down, map, down.uv[0]));
    for (std::size_t i = 0; i < up.positions.size(); ++i) {
        EXPECT_FLOAT_EQ(up.positions[i].z, 2.25f);
        EXPECT_FLOAT_EQ(down.positions[i].z, -2.25f);
        EXPECT_EQ(up.normals[i], glm::vec3(0, 0, 1));
    }
}

TEST(Displace, NoCrackOpensAtASeam) {
    Primitive ball = sphere(16);
    HeightMap map{.image = paint(32,
                                 [](glm::vec2 uv) {
                                     return glm::vec4(0.5f + 0.5f * std::sin(40 * uv.x) * std::cos(9 * uv.y));
                                 }),
                  .scale = 0.3f};
    const std::vector<glm::vec3> before = ball.positions, normals = ball.normals;
    const std::size_t count = before.size();
    ASSERT_TRUE(displace(ball, map, ball.uv[0]));
    bool seen = false;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = i + 1; j < count; ++j)
            if (before[i] == before[j]) {
                seen = true;
                EXPECT_EQ(ball.positions[i], ball.positions[j]);
                if (normals[i] == normals[j]) {
                    EXPECT_EQ(ball.normals[i], ball.normals[j]);
                }
            }
    EXPECT_TRUE(seen);
    for (const glm::vec3& normal : ball.normals)
        EXPECT_NEAR(glm::length(normal), 1, 1e-5f);
}

TEST(Displace, HardEdgesStayHardAndClosed) {
    // Two squares at a right angle that share an edge, each with its own normals.
    Primitive corner;
    corner.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0},  {0, 1, 0},
                        {0, 0, 0}, {0, 1, 0}, {0, 1, -1}, {0, 0, -1}};
    corner.normals = {{0, 0, 1},  {0, 0, 1},  {0, 0, 1},  {0, 0, 1},
                      {-1, 0, 0}, {-1, 0, 0}, {-1, 0, 0}, {-1, 0, 0}};
    corner.uv[0].assign(8, {0.5f, 0.5f});
    corner.indices = {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
    const HeightMap map{.image = paint(1, [](glm::vec2) { return glm::vec4(1); }), .scale = 0.1f};
    ASSERT_TRUE(displace(corner, map));
    EXPECT_EQ(corner.positions[0], corner.positions[4]);
    EXPECT_EQ(corner.positions[3], corner.positions[5]);
    EXPECT_NEAR(glm::length(corner.positions[0]), 0.1f, 1e-6f);
    EXPECT_LT(glm::dot(corner.normals[0], corner.normals[4]), 0.3f);
    EXPECT_TRUE(corner.tangents.empty());
}

TEST(Displace, RefusesWhatHasNoCoordinatesOrNoHeights) {
    Primitive primitive = grid(1);
    EXPECT_EQ(displace(primitive, {}).error().code, "height.image");
    HeightMap map = ramp(1);
    map.uvSet = 1;
    EXPECT_EQ(displace(primitive, map).error().code, "height.uv");
}

TEST(Displace, TakesTheMaterialThatIsAskedFor) {
    SceneBuilder builder;
    const int flat = builder.addMaterial({}), bumpy = builder.addMaterial({});
    builder.add(grid(4), flat);
    builder.add(grid(4), bumpy);
    ASSERT_TRUE(displace(builder.scene, ramp(1), bumpy));
    EXPECT_EQ(builder.scene.meshes[0].primitives[0].positions, grid(4).positions);
    EXPECT_NE(builder.scene.meshes[1].primitives[0].positions, grid(4).positions);
    ASSERT_TRUE(displace(builder.scene, ramp(1)));
    EXPECT_NE(builder.scene.meshes[0].primitives[0].positions, grid(4).positions);
}

} // namespace
} // namespace franken::test
