// SPDX-License-Identifier: MIT
// The pictures of examples/embed, which other tests made from an installed package.
#include "engine/world.h"
#include "generator_only/panel.h"
#include "support/brdf_reference.h"
#include "support/draw_scene.h"
#include "support/shapes.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace franken::test {
namespace {

Picture pictureOf(const std::string& example) {
    return readPicture(std::filesystem::path(EMBED_PICTURES) / example / (example + ".png"));
}

Primitive toPrimitive(const ::Mesh& mesh) {
    Primitive primitive;
    for (const Vertex& vertex : mesh.vertices) {
        primitive.positions.push_back(vertex.position);
        primitive.normals.push_back(vertex.normal);
        primitive.tangents.push_back(vertex.tangent);
        primitive.uv[0].push_back(vertex.uv);
        primitive.bounds.add(vertex.position);
    }
    primitive.indices.assign(mesh.triangles.begin(), mesh.triangles.end());
    return primitive;
}

/// The engine's world as the library's own scene.
Scene toScene(const World& world) {
    SceneBuilder builder;
    const int tiles =
        builder.addTexture({"", world.tiles.size, world.tiles.size, world.tiles.texels}, Filter::Linear);
    const int ridges =
        builder.addTexture({"", world.ridges.size, world.ridges.size, world.ridges.texels}, Filter::Linear);
    for (const Thing& thing : world.things) {
        Material material;
        material.factors.baseColor = {thing.paint.color.r, thing.paint.color.g, thing.paint.color.b, 1};
        material.factors.metallic = thing.paint.metallic;
        material.factors.roughness = thing.paint.roughness;
        if (thing.paint.textured) {
            material.textures[TextureRole::BaseColor].texture = tiles;
            material.textures[TextureRole::Normal].texture = ridges;
        }
        builder.add(toPrimitive(thing.mesh), builder.addMaterial(material), thing.place);
    }
    builder.addSun(world.sunDirection, {1, 1, 1}, world.sunLux);
    builder.scene.lights.push_back({.name = "lamp",
                                    .kind = Light::Kind::Point,
                                    .color = world.lampColor,
                                    .intensity = world.lampCandela,
                                    .position = world.lampPosition});
    return builder.scene;
}

Shot toShot(const World& world) {
    Shot shot{.scene = toScene(world), .camera = {}, .lighting = {}};
    shot.camera = {.name = "",
                   .yfov = world.yfov,
                   .znear = world.near,
                   .zfar = world.far,
                   .world = glm::inverse(glm::lookAt(world.eye, world.lookAt, glm::vec3(0, 1, 0)))};
    shot.lighting = lightingOf(shot.scene);
    shot.lighting.ambient = {.kind = Ambient::Color,
                             .color = {world.ambient.r, world.ambient.g, world.ambient.b}};
    shot.look.toneMap = ToneMap::Neutral;
    return shot;
}

class EmbedTest : public PictureTest {
protected:
    EmbedTest() : PictureTest({320, 240}) {}
};

INSTANTIATE_TEST_SUITE_P(Backends, EmbedTest, allBackends(), backendName);

TEST_P(EmbedTest, TheForeignEngineDrawsWhatTheRendererDraws) {
    World world = makeWorld();
    animate(world, 59.0f / 60);
    const Picture expected = draw(toShot(world));
    const Picture actual = pictureOf("engine");
    ASSERT_EQ(actual.width, 320);
    ASSERT_EQ(actual.height, 240);
    const auto covered = [&](int x, int y) { // Where the renderer left no background.
        const std::uint8_t* const pixel = &expected.rgba[4 * static_cast<std::size_t>(y * 320 + x)];
        return pixel[0] + pixel[1] + pixel[2] > 0;
    };
    const Difference difference = compare(actual, expected, covered);
    std::cout << difference << "\n";
    EXPECT_GT(difference.pixels, 25000u);
    // The renderer multiplies matrices in double precision, the engine in float.
    EXPECT_LE(difference.max(), 1) << writeDifference("embed-engine", actual, expected);
    EXPECT_LE(difference.mean, 0.001);
}

TEST_P(EmbedTest, TheForeignEnginesOwnPassIsStillThere) {
    const Picture picture = pictureOf("engine");
    ASSERT_EQ(picture.rgba.size(), 4u * 320 * 240);
    // The gradient's upper end is (0.10, 0.13, 0.20); the wave moves it by 0.02 of the gradient's height.
    EXPECT_NEAR(picture.rgba[0], 0.10 * 255, 2);
    EXPECT_NEAR(picture.rgba[1], 0.13 * 255, 2);
    EXPECT_NEAR(picture.rgba[2], 0.20 * 255, 2);
}

double encode(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

glm::dvec3 toVector(const Float3& v) { return {v[0], v[1], v[2]}; }

TEST(GeneratorOnly, EveryPixelIsTheBrdfInDoublePrecision) {
    const Picture picture = pictureOf("generator_only");
    ASSERT_EQ(picture.width, kPixels);
    ASSERT_EQ(picture.height, kPixels);
    double worst = 0;
    int brightest = 0;
    for (int y = 0; y < kPixels; ++y)
        for (int x = 0; x < kPixels; ++x) {
            const glm::dvec3 position((2 * x + 1.0) / kPixels - 1, 1 - (2 * y + 1.0) / kPixels, 0);
            const glm::dvec3 radiance =
                radianceOf({.normal = {0, 0, 1},
                            .toCamera = glm::normalize(toVector(kEye) - position),
                            .toLight = -glm::normalize(toVector(kSun.direction)),
                            .baseColor = {kPanel.baseColor[0], kPanel.baseColor[1], kPanel.baseColor[2]},
                            .metallic = kPanel.metallic,
                            .roughness = kPanel.roughness},
                           Brdf::Gltf);
            for (int channel = 0; channel < 3; ++channel) {
                const int code = picture.rgba[static_cast<std::size_t>(4 * (y * kPixels + x) + channel)];
                const double wanted = 255 * encode(std::min(radiance[channel], 1.0));
                worst = std::max(worst, std::abs(code - wanted));
                brightest = std::max(brightest, code);
            }
        }
    std::cout << "off by up to " << worst << " codes, brightest " << brightest << "\n";
    EXPECT_LE(worst, 0.75); // Half a code by rounding to 8 bits, and the 0.22 % that brdf_test.cpp finds.
    EXPECT_GT(brightest, 150);
}

} // namespace
} // namespace franken::test
