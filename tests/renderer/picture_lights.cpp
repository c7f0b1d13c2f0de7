// SPDX-License-Identifier: MIT
#include "picture_shots.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace franken::test {
namespace {

Shot fourSuns() {
    SceneBuilder builder;
    builder.addSun({-1, -1, -1}, {1, 0.2f, 0.2f}, 2);
    builder.addSun({1, -1, -1}, {0.2f, 1, 0.2f}, 2);
    builder.addSun({0, 1, -1}, {0.2f, 0.2f, 1}, 2);
    builder.addSun({0, -0.2f, 1}, {1, 1, 1}, 4);
    builder.add(sphere(kRings), builder.addMaterial(plain(0.3f, 0.4f)));
    return shotOfScene(std::move(builder));
}

Light punctualAt(const glm::vec3& position, const glm::vec3& color, Light::Kind kind = Light::Kind::Point) {
    Light light;
    light.kind = kind;
    light.position = position;
    light.direction = glm::normalize(-position);
    light.color = color;
    light.intensity = 4;
    light.innerConeAngle = 0.1f;
    light.outerConeAngle = 0.35f;
    return light;
}

Shot punctualLights(Light::Kind kind) {
    SceneBuilder builder;
    builder.scene.lights = {punctualAt({-1.2f, 0.5f, 1.5f}, {1, 0.5f, 0.3f}, kind),
                            punctualAt({1.4f, 0.8f, 1.2f}, {0.3f, 0.5f, 1}, kind)};
    builder.scene.lights[1].range = 2.5f;
    builder.add(square(), builder.addMaterial(plain(0, 0.3f)));
    return shotOfScene(std::move(builder));
}

Shot sunsAndPunctualLights() {
    Shot shot = fourSuns();
    shot.lighting.suns.resize(2);
    shot.scene.lights = {punctualAt({1, 1, 1.5f}, {1, 1, 0.5f}, Light::Kind::Spot)};
    shot.lighting.punctualLights = lightingOf(shot.scene).punctualLights;
    return shot;
}

/// Blue above, brown below, a bright spot to the right.
Environment makeSky() {
    Environment sky{.width = 64, .height = 32, .texels = {}};
    for (int y = 0; y < sky.height; ++y)
        for (int x = 0; x < sky.width; ++x) {
            const float up = 1 - (static_cast<float>(y) + 0.5f) / 16;
            const bool spot = std::abs(x - 46) < 3 && std::abs(y - 10) < 3;
            sky.texels.push_back(spot ? glm::vec3(20, 18, 14)
                                      : glm::mix(glm::vec3(0.25f, 0.2f, 0.12f), glm::vec3(0.3f, 0.5f, 1),
                                                 glm::smoothstep(-0.1f, 0.3f, up)));
        }
    return sky;
}

/// Lit by that sky alone, which is seen behind it.
Shot underSky(Shot shot) {
    const Environment sky = makeSky();
    shot.lighting.suns.clear();
    shot.lighting.ambient = {.kind = Ambient::Sky, .sky = skyCoefficients(sky)};
    shot.skybox = encodeSkybox(sky, 64);
    shot.look.toneMap = ToneMap::Neutral;
    return shot;
}

/// A perfect mirror: it shows the sky, and its bright spot.
Shot mirrored() {
    Shot shot = underSky(ball(plain(1, 0)));
    shot.lighting.reflection = Reflection::Lookup;
    shot.reflection = {filterReflection(makeSky()), reflectionLookup()};
    return shot;
}

} // namespace

std::vector<PictureRow> lightRows() {
    return {
        {"four_suns", fourSuns},
        {"point_lights", [] { return punctualLights(Light::Kind::Point); }},
        {"spots", [] { return punctualLights(Light::Kind::Spot); }},
        {"suns_and_punctual_lights", sunsAndPunctualLights},
        {"sky", [] { return underSky(dressedBall([](SceneBuilder&, Material&) {})); }},
        {"mirror", mirrored},
    };
}

} // namespace franken::test
