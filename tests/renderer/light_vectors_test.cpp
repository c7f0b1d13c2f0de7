// SPDX-License-Identifier: MIT
// Light vectors per vertex against per pixel, on the meshes that tell how fine is fine enough.
#include "franken/tessellation.h"
#include "support/draw_scene.h"

#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>

namespace franken::test {
namespace {

/// A unit sphere of segments x rings quads, with tangents.
Primitive makeSphere(int segments, int rings) {
    Primitive sphere;
    for (int ring = 0; ring <= rings; ++ring)
        for (int segment = 0; segment <= segments; ++segment) {
            const glm::vec2 uv(float(segment) / float(segments), float(ring) / float(rings));
            const float longitude = uv.x * glm::two_pi<float>(), latitude = uv.y * glm::pi<float>();
            const glm::vec3 normal(std::sin(latitude) * std::sin(longitude), std::cos(latitude),
                                   std::sin(latitude) * std::cos(longitude));
            sphere.positions.push_back(normal);
            sphere.normals.push_back(normal);
            sphere.tangents.emplace_back(std::cos(longitude), 0.0f, -std::sin(longitude), 1.0f);
            sphere.uv[0].push_back(uv);
            sphere.bounds.add(normal);
        }
    const auto at = [&](int segment, int ring) { return std::uint32_t(ring * (segments + 1) + segment); };
    for (int ring = 0; ring < rings; ++ring)
        for (int segment = 0; segment < segments; ++segment)
            for (const auto& [s, r] : {std::pair(0, 0), {0, 1}, {1, 1}, {0, 0}, {1, 1}, {1, 0}})
                sphere.indices.push_back(at(segment + s, ring + r));
    return sphere;
}

/// Soft waves, so that no texel stands out.
Image makeWaves() {
    constexpr int kSize = 128;
    Image image{"waves", kSize, kSize, {}};
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            const float phase = 12 * glm::pi<float>() / kSize;
            const float slope[2] = {0.15f * std::sin(phase * float(x)), 0.15f * std::sin(phase * float(y))};
            for (const float component : {slope[0], slope[1], 1.0f})
                image.rgba.push_back(static_cast<std::uint8_t>(std::lround(127.5f + 127.5f * component)));
            image.rgba.push_back(255);
        }
    return image;
}

Scene makeScene(int segments, int rings, bool normalMap) {
    Scene scene;
    scene.meshes.push_back({"sphere", {makeSphere(segments, rings)}});
    scene.instances.push_back({"sphere", 0, glm::mat4(1.0f), false});
    Material material;
    material.factors.baseColor = {0.8f, 0.5f, 0.3f, 1};
    material.factors.metallic = 0.3f;
    material.factors.roughness = 0.3f;
    if (normalMap) {
        scene.images.push_back(makeWaves());
        scene.textures.push_back({0});
        material.textures[TextureRole::Normal].texture = 0;
    }
    scene.materials.push_back(material);
    return scene;
}

struct Row {
    int segments, rings;
    double share; ///< Of the picture's pixels that may differ by more than one code (the goal of the form).
};

class LightVectorsTest : public PictureTest {
protected:
    LightVectorsTest() : PictureTest({256, 256}) {}

    /// share: of the picture's pixels that may differ by more than one code.
    static void compareForms(const Picture& perVertex, const Picture& perPixel, double share) {
        const Difference difference = compareLit(perVertex, perPixel);
        const double above = difference.shareAbove(1) * double(difference.pixels) / (256.0 * 256.0);
        std::cout << 100 * above << " % above 1 code, max " << difference.max() << "\n";
        EXPECT_NE(perVertex.rgba, perPixel.rgba) << "another program must have drawn";
        EXPECT_LE(above, share);
    }
};

INSTANTIATE_TEST_SUITE_P(Backends, LightVectorsTest, allBackends(), backendName);

constexpr Row kRows[] = {{64, 32, 0.005}, {256, 128, 0.0005}};

TEST_P(LightVectorsTest, PerVertexIsPerPixelOnFineMeshes) {
    const std::vector<Sun> suns = {{{-1, -1, -1}, {1, 0.9f, 0.8f}, 2},
                                   {{1, -0.5f, -0.5f}, {0.5f, 0.6f, 1}, 1},
                                   {{0, -1, 0.3f}, {1, 1, 1}, 0.5f},
                                   {{0.3f, 1, -1}, {1, 0.5f, 0.5f}, 0.5f}};
    for (const Row& row : kRows)
        for (const bool normalMap : {false, true})
            for (const std::size_t count : {1u, 2u, 4u}) {
                Shot shot{
                    .scene = makeScene(row.segments, row.rings, normalMap), .camera = {}, .lighting = {}};
                shot.camera.world[3] = glm::vec4(0, 0, 3, 1);
                shot.lighting.suns.assign(suns.begin(), suns.begin() + std::ptrdiff_t(count));
                const Picture perPixel = draw(shot);
                shot.look.lightVectors = LightVectors::PerVertex;
                std::cout << row.segments << "x" << row.rings << (normalMap ? ", normal map, " : ", ")
                          << count << " suns: ";
                for (const Target target : kForms)
                    compareForms(draw(withForms(shot, target)), perPixel, row.share);
            }
}

TEST_P(LightVectorsTest, CoarseMeshesStayPerPixel) {
    Shot shot{.scene = makeScene(16, 8, false), .camera = {}, .lighting = {}};
    shot.camera.world[3] = glm::vec4(0, 0, 3, 1);
    shot.lighting.suns = {{{-1, -1, -1}, {1, 1, 1}, 2}};
    const Picture perPixel = draw(shot);
    shot.look.lightVectors = LightVectors::PerVertex;
    EXPECT_EQ(draw(shot).rgba, perPixel.rgba);
}

TEST(NormalTurn, IsTheAngleWithinTriangles) {
    EXPECT_NEAR(glm::degrees(normalTurn(makeSphere(64, 32))), 7.9f, 0.2f);
    EXPECT_NEAR(glm::degrees(normalTurn(makeSphere(256, 128))), 2.0f, 0.1f);
    EXPECT_EQ(normalTurn(Primitive{}), 0.0f);
}

} // namespace
} // namespace franken::test
