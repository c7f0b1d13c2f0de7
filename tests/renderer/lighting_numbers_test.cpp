// SPDX-License-Identifier: MIT
// Exposure changed alone: all kinds of light follow it, in the frame that comes next, as if it had been so
// from the beginning.
#include "numbers.h"

#include <cmath>

namespace franken::test {
namespace {

using ExposureTest = PictureTest;
INSTANTIATE_TEST_SUITE_P(Backends, ExposureTest, allBackends(), backendName);

Environment plainSky() {
    return {.width = 32, .height = 16, .texels = std::vector<glm::vec3>(32 * 16, {0.4f, 0.3f, 0.2f})};
}

struct Row {
    const char* what;
    void (*light)(Shot& shot);
};

const Row kRows[] = {
    {"what glows",
     [](Shot& shot) {
         shot.scene.materials[0].factors.emissive = {0.4f, 0.3f, 0.2f};
     }},
    {"a texture that glows",
     [](Shot& shot) {
         SceneBuilder builder{.scene = shot.scene};
         builder.scene.materials[0].factors.emissive = {0.4f, 0.3f, 0.2f};
         builder.scene.materials[0].textures[TextureRole::Emissive].texture =
             builder.addTexture(texel(255, 200, 255));
         shot.scene = builder.scene;
         shot.look.decode = Decode::Fast;
     }},
    {"a sun",
     [](Shot& shot) {
         shot.lighting.suns = {{.direction = {0, 0, -1}, .illuminance = 1.2f}};
     }},
    {"a lamp",
     [](Shot& shot) {
         shot.lighting.punctualLights = {{.position = {0, 0, 2}, .intensity = 4}};
     }},
    {"ambient light",
     [](Shot& shot) {
         shot.lighting.ambient = {.kind = Ambient::Color, .color = {0.4f, 0.3f, 0.2f}};
     }},
    {"a sky",
     [](Shot& shot) { shot.lighting.ambient = {.kind = Ambient::Sky, .sky = skyCoefficients(plainSky())}; }},
    {"a sky that is mirrored",
     [](Shot& shot) {
         shot.lighting.ambient.kind = Ambient::Sky;
         shot.lighting.reflection = Reflection::Lookup;
         shot.reflection = ReflectionMaps{{texel(255, 220, 180, 100), 2}, reflectionLookup()};
         shot.scene.materials[0].factors.metallic = 0.5f;
     }},
    {"a sky behind the model",
     [](Shot& shot) {
         shot.scene.instances[0].world[3] = glm::dvec4(0, 100, 0, 1);
         shot.skybox = encodeSkybox(plainSky(), 4);
     }},
};

Shot shotOf(const Row& row) {
    Material material;
    material.factors.metallic = 0;
    Shot shot = filledBy(material);
    row.light(shot);
    return shot;
}

TEST_P(ExposureTest, ChangedAloneIsSeenAndMultipliesAllLight) {
    for (const Row& row : kRows) {
        SCOPED_TRACE(row.what);
        Shot shot = shotOf(row);
        Renderer renderer(gl());
        ASSERT_TRUE(renderer.load(shot.scene));
        ASSERT_TRUE(renderer.setSkybox(shot.skybox ? &*shot.skybox : nullptr));
        ASSERT_TRUE(renderer.setReflection(shot.reflection ? &*shot.reflection : nullptr));
        renderer.setLook(shot.look);
        const DrawTarget target{.framebuffer = surface().framebuffer(), .width = 64, .height = 64};
        std::array<Picture, 2> pictures;
        for (std::size_t i = 0; i < 2; ++i) {
            shot.lighting.exposure = i == 0 ? 1.0f : 2.0f;
            renderer.setLighting(shot.lighting);
            ASSERT_TRUE(renderer.draw(viewpointOf(shot.camera, 1), target));
            pictures[i] = readBack();
        }
        const auto once = codesOf(pictures[0]), twice = codesOf(pictures[1]);
        EXPECT_GT(once[0], 40);
        for (std::size_t channel = 0; channel < 3; ++channel)
            EXPECT_NEAR(twice[channel], 2 * once[channel], 2) << channel;
        EXPECT_EQ(compareLit(draw(shot), pictures[1]).max(), 0) << "as from the beginning";
    }
}

Lighting reflecting() {
    Lighting lighting;
    lighting.ambient = {.kind = Ambient::Sky, .sky = skyCoefficients(plainSky())};
    lighting.reflection = Reflection::Lookup;
    return lighting;
}

/// Lights that need other programs, one after the other.
const std::pair<const char*, void (*)(Lighting&)> kChanges[] = {
    {"the sky is mirrored", [](Lighting&) {}},
    {"the sky is not mirrored", [](Lighting& lighting) { lighting.reflection = Reflection::None; }},
    {"the sky is mirrored again", [](Lighting& lighting) { lighting.reflection = Reflection::Lookup; }},
    {"ambient light",
     [](Lighting& lighting) {
         lighting.ambient = {.kind = Ambient::Color, .color = {0.1f, 0.2f, 0.3f}};
     }},
    {"a sun",
     [](Lighting& lighting) {
         lighting.suns = {{.direction = {0, 0, -1}, .illuminance = 0.2f}};
     }},
    {"a lamp",
     [](Lighting& lighting) {
         lighting.punctualLights = {{.position = {0, 0, 2}, .intensity = 0.4f}};
     }},
    {"a spot",
     [](Lighting& lighting) {
         lighting.punctualLights[0].spot = true;
         lighting.punctualLights[0].outerCone = 0.2f;
     }},
    {"no sun", [](Lighting& lighting) { lighting.suns.clear(); }},
    {"no ambient light", [](Lighting& lighting) { lighting.ambient.kind = Ambient::None; }},
};

using LightingTest = PictureTest;
INSTANTIATE_TEST_SUITE_P(Backends, LightingTest, allBackends(), backendName);

TEST_P(LightingTest, EachChangeIsSeenInTheNextFrame) {
    Material material;
    material.factors.metallic = 0.5f;
    material.factors.roughness = 0.4f;
    Shot shot = filledBy(material);
    shot.reflection = ReflectionMaps{{texel(255, 120, 60, 100), 2}, reflectionLookup()};
    shot.lighting = reflecting();
    Renderer renderer(gl());
    ASSERT_TRUE(renderer.load(shot.scene));
    ASSERT_TRUE(renderer.setReflection(&*shot.reflection));
    renderer.setLook(shot.look);
    const DrawTarget target{.framebuffer = surface().framebuffer(), .width = 64, .height = 64};
    std::vector<Picture> pictures;
    std::vector<Lighting> lights;
    for (const auto& [what, change] : kChanges) {
        change(shot.lighting);
        lights.push_back(shot.lighting);
        renderer.setLighting(shot.lighting);
        ASSERT_TRUE(renderer.draw(viewpointOf(shot.camera, 1), target)) << what;
        pictures.push_back(readBack());
    }
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        shot.lighting = lights[i];
        EXPECT_EQ(compareLit(draw(shot), pictures[i]).max(), 0)
            << kChanges[i].first << ": as from the beginning";
        if (i > 0) {
            EXPECT_GT(compareLit(pictures[i], pictures[i - 1]).max(), 4) << kChanges[i].first;
        }
    }
}

} // namespace
} // namespace franken::test
