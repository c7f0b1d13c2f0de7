// SPDX-License-Identifier: MIT
// What golden pictures are made of.
#pragma once

#include "picture_scenes.h"
#include "support/shapes.h"

#include <utility>

namespace franken::test {

inline constexpr glm::vec4 kOrange(0.9f, 0.5f, 0.2f, 1), kBlue(0.2f, 0.4f, 0.9f, 1), kWhite(1);
inline constexpr int kRings = 24;

inline Camera cameraAt(float distance) {
    Camera camera;
    camera.yfov = 0.6f;
    camera.world[3] = {0, 0, distance, 1};
    return camera;
}

inline Shot shotOfScene(SceneBuilder builder) {
    if (builder.scene.lights.empty())
        builder.addSun({-0.6f, -0.5f, -0.7f}, {1, 0.95f, 0.9f}, 3);
    return {.scene = builder.scene, .camera = cameraAt(4), .lighting = lightingOf(builder.scene)};
}

inline Material plain(float metallic, float roughness) {
    Material material;
    material.factors.baseColor = toFloat4(kOrange);
    material.factors.metallic = metallic;
    material.factors.roughness = roughness;
    return material;
}

inline Shot ball(const Material& material) {
    SceneBuilder builder;
    builder.add(sphere(kRings), builder.addMaterial(material));
    return shotOfScene(std::move(builder));
}

/// A ball whose material gets its textures from `dress`.
template<typename Dress>
Shot dressedBall(Dress dress) {
    SceneBuilder builder;
    Material material = plain(0, 0.5f);
    material.factors.baseColor = toFloat4(kWhite);
    dress(builder, material);
    builder.add(sphere(kRings), builder.addMaterial(material));
    return shotOfScene(std::move(builder));
}

/// The pictures of lights and skies.
std::vector<PictureRow> lightRows();

} // namespace franken::test
