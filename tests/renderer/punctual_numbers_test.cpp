// SPDX-License-Identifier: MIT
// Punctual lights in floats against double precision, as KHR_lights_punctual prints them: falloff, range,
// cone, colour and place.
#include "support/brdf_reference.h"
#include "support/draw_scene.h"
#include "support/point_shader.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace franken::test {
namespace {

using PunctualTest = OffscreenTest;
INSTANTIATE_TEST_SUITE_P(Backends, PunctualTest, allBackends(), backendName);

glm::dvec3 toVector(const Float3& v) { return {v[0], v[1], v[2]}; }

constexpr Float3 kToCamera{0.6f, 0, 0.8f};
constexpr Float3 kBase{0.8f, 0.5f, 0.3f};

MaterialFactors factors() {
    return {.baseColor = {kBase[0], kBase[1], kBase[2], 1}, .metallic = 0.25f, .roughness = 0.5f};
}

/// "Inner and Outer Cone Angles", by the angle from the axis.
double coneOf(const PunctualLight& light, const glm::dvec3& toLight) {
    if (!light.spot)
        return 1;
    const double cosine = glm::dot(-toLight, glm::normalize(toVector(light.direction)));
    const double outer = std::cos(double{light.outerCone}), inner = std::cos(double{light.innerCone});
    const double inside = std::clamp((cosine - outer) / (inner - outer), 0.0, 1.0);
    return inside * inside;
}

/// The irradiance at the origin of a surface that faces the light: "Range Property".
glm::dvec3 irradianceOf(const PunctualLight& light) {
    const glm::dvec3 place(light.position[0], light.position[1], light.position[2]);
    const double distance = glm::length(place);
    const double window = light.range > 0 ? std::clamp(1 - std::pow(distance / light.range, 4), 0.0, 1.0) : 1;
    return toVector(light.color) * double{light.intensity} *
           (window * coneOf(light, place / distance) / (distance * distance));
}

glm::dvec3 expectedOf(const std::vector<PunctualLight>& lights, double exposure) {
    glm::dvec3 sum(0);
    for (const PunctualLight& light : lights) {
        const LitPoint point{
            .toCamera = glm::normalize(toVector(kToCamera)),
            .toLight = glm::normalize(glm::dvec3(light.position[0], light.position[1], light.position[2])),
            .baseColor = toVector(kBase),
            .metallic = 0.25,
            .roughness = 0.5};
        sum += radianceOf(point, Brdf::Gltf) * irradianceOf(light) * (exposure / std::numbers::pi);
    }
    return sum;
}

struct Row {
    const char* what;
    std::vector<PunctualLight> lights;
    float exposure = 1;
};

const PunctualLight kLamp{.position = {0.5, 1, 2}, .color = {1, 0.6f, 0.2f}, .intensity = 20};

PunctualLight lamp(void (*change)(PunctualLight&)) {
    PunctualLight light = kLamp;
    change(light);
    return light;
}

PunctualLight spot(const Float3& direction, float inner, float outer) {
    PunctualLight light = kLamp;
    light.spot = true;
    light.direction = direction;
    light.innerCone = inner;
    light.outerCone = outer;
    return light;
}

const Row kRows[] = {
    {"a lamp", {kLamp}},
    {"twice as far", {lamp([](PunctualLight& light) {
         light.position = {1, 2, 4};
     })}},
    {"near", {lamp([](PunctualLight& light) {
         light.position = {0.05, 0.1, 0.2};
     })}},
    {"another colour", {lamp([](PunctualLight& light) {
         light.color = {0.1f, 0.2f, 0.9f};
     })}},
    {"half its range away", {lamp([](PunctualLight& light) { light.range = 4.5f; })}},
    {"nearly its range away", {lamp([](PunctualLight& light) { light.range = 2.6f; })}},
    {"beyond its range", {lamp([](PunctualLight& light) { light.range = 2; })}},
    {"exposed", {kLamp}, 0.25f},
    {"in a spot's middle", {spot({-0.5f, -1, -2}, 0.2f, 0.5f)}},
    {"at a spot's rim", {spot({-0.5f, -1.7f, -2}, 0.1f, 0.6f)}},
    {"nearer to a spot's rim", {spot({-0.5f, -2.1f, -2}, 0.1f, 0.6f)}},
    {"outside a spot", {spot({-0.5f, 1, -2}, 0.2f, 0.5f)}},
    {"a spot's direction has any length", {spot({-5, -17, -20}, 0.1f, 0.6f)}},
    {"a point light beside a spot", {kLamp, spot({-0.5f, -1.7f, -2}, 0.1f, 0.6f)}},
    {"four",
     {kLamp, lamp([](PunctualLight& light) {
          light.position = {-1, -1, 1};
      }),
      lamp([](PunctualLight& light) {
          light.position = {2, 0, 1};
      }),
      lamp([](PunctualLight& light) {
          light.position = {0, -2, 0.5};
      })}},
};

ShadedPoint pointOf(const Row& row) {
    ShadedPoint point;
    point.frame.cameraPosition = kToCamera;
    point.material = packMaterial(factors(), Brdf::Gltf, 1);
    for (std::size_t i = 0; i < row.lights.size(); ++i)
        packPunctualLight(point.lights, i, row.lights[i], {kToCamera[0], kToCamera[1], kToCamera[2]},
                          row.exposure);
    return point;
}

TEST_P(PunctualTest, AreWhatTheExtensionSays) {
    for (const Target target : kForms)
        for (const Row& row : kRows) {
            Permutation permutation;
            permutation.punctualLights = static_cast<std::uint8_t>(row.lights.size());
            permutation.spots = row.lights.back().spot;
            permutation.output = Output::Linear;
            permutation.target = target;
            const auto shaded = shade(gl(), canonicalise(permutation)->permutation, {pointOf(row)});
            ASSERT_EQ(shaded.size(), 1u);
            const glm::dvec3 expected = expectedOf(row.lights, row.exposure);
            for (int channel = 0; channel < 3; ++channel)
                EXPECT_NEAR(shaded[0][static_cast<std::size_t>(channel)], expected[channel],
                            2e-3 * expected[channel] + 1e-5)
                    << row.what << ", channel " << channel << ", form " << static_cast<int>(target);
        }
}

TEST(PunctualLights, OfASceneKeepWhatTheFileSays) {
    Scene scene;
    scene.lights.push_back({.name = "lamp",
                            .kind = Light::Kind::Spot,
                            .color = {0.1f, 0.2f, 0.3f},
                            .intensity = 4,
                            .range = 5,
                            .innerConeAngle = 0.6f,
                            .outerConeAngle = 0.7f,
                            .position = {8, 9, 10},
                            .direction = {0, 0.6f, 0.8f}});
    const Lighting lighting = lightingOf(scene);
    ASSERT_EQ(lighting.punctualLights.size(), 1u);
    const PunctualLight& light = lighting.punctualLights[0];
    EXPECT_EQ(light.position, (Double3{8, 9, 10}));
    EXPECT_EQ(light.direction, (Float3{0, 0.6f, 0.8f}));
    EXPECT_EQ(light.color, (Float3{0.1f, 0.2f, 0.3f}));
    EXPECT_EQ((Float4{light.intensity, light.range, light.innerCone, light.outerCone}),
              (Float4{4, 5, 0.6f, 0.7f}));
    EXPECT_TRUE(light.spot);
}

} // namespace
} // namespace franken::test
