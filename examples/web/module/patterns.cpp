// SPDX-License-Identifier: MIT
// The page's own sphere, and a texture for each role of its material.
#include "exchange.h"
#include "franken/complete.h"
#include "franken/generator/texture_role.h"
#include "write_primitive.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace franken::web {
namespace {

constexpr int kSize = 128; ///< Texels, each way.
constexpr int kTiles = 8;  ///< Each way.

Primitive g_sphere;
std::vector<std::uint8_t> g_texels;

/// Where a texel lies: how far down the texture, from -1 to 1 within its tile, and how much that tile is a
/// dark one. No edge is sharp: renderers differ in how they filter, and pictures of several are compared.
struct Place {
    float down;
    glm::vec2 inTile;
    float dark;
};

Place placeOf(int x, int y) {
    const glm::vec2 tile = (glm::vec2(x, y) + 0.5f) * (static_cast<float>(kTiles) / kSize);
    const glm::vec2 waves = glm::sin(glm::pi<float>() * tile);
    return {(static_cast<float>(y) + 0.5f) / kSize, 2.0f * (tile - glm::floor(tile)) - 1.0f,
            1 - glm::smoothstep(-0.3f, 0.3f, waves.x * waves.y)};
}

/// 1 in the middle of a tile, 0 outside of a circle in it.
float disc(const Place& place, float radius) {
    return 1 - glm::smoothstep(radius - 0.25f, radius + 0.25f, glm::length(place.inTile));
}

glm::vec4 baseColor(const Place& place) {
    const glm::vec3 color = glm::mix(glm::vec3(0.95f, 0.9f, 0.8f), glm::vec3(0.55f, 0.6f, 0.68f), place.dark);
    return {color, glm::mix(1.0f, 0.3f, disc(place, 0.5f) * (1 - place.dark))};
}

/// Each tile is a shallow bump.
glm::vec4 normal(const Place& place) {
    const glm::vec2 slope = 0.5f * place.inTile * disc(place, 0.75f);
    return {0.5f + 0.5f * glm::normalize(glm::vec3(slope.x, -slope.y, 1)), 1};
}

float occlusion(const Place& place) {
    const glm::vec2 fromMiddle = glm::abs(place.inTile);
    return 1 - 0.7f * glm::smoothstep(0.4f, 1.0f, std::max(fromMiddle.x, fromMiddle.y));
}
float roughness(const Place& place) { return 0.15f + 0.8f * place.down; }
float metalness(const Place& place) { return place.dark; }
float emission(const Place& place) { return disc(place, 0.4f) * (1 - place.dark); }

glm::vec4 texel(TextureRole role, const Place& place) {
    switch (role) {
    case TextureRole::BaseColor:
        return baseColor(place);
    case TextureRole::Normal:
        return normal(place);
    case TextureRole::MetallicRoughness:
        return {occlusion(place), roughness(place), metalness(place), 1};
    case TextureRole::Metallic:
        return glm::vec4(glm::vec3(metalness(place)), 1);
    case TextureRole::Roughness:
        return glm::vec4(glm::vec3(roughness(place)), 1);
    case TextureRole::Occlusion:
        return glm::vec4(glm::vec3(occlusion(place)), 1);
    case TextureRole::Emissive:
        return glm::vec4(glm::vec3(emission(place)), 1);
    case TextureRole::Skybox:
    case TextureRole::Reflection:
    case TextureRole::ReflectionLookup:
        break;
    }
    return glm::vec4(0);
}

} // namespace
} // namespace franken::web

using namespace franken;
using namespace franken::web;

/// A sphere of radius 1 with so many rings, as arrays, second coordinates and vertex colours among them.
FRANKEN_EXPORT(makeSphere) void makeSphere(int rings) {
    g_sphere = sphere(1, rings);
    for (std::size_t i = 0; i < g_sphere.positions.size(); ++i) {
        g_sphere.uv[1].push_back(0.5f * g_sphere.uv[0][i]);
        g_sphere.colors.emplace_back(0.5f + 0.5f * g_sphere.normals[i], 1);
    }
    Json json;
    writePrimitive(json, g_sphere);
    answer(json);
}

/// The texture of a role of textureRoles(): {"width", "height", "rgba"}.
FRANKEN_EXPORT(makeTexture) void makeTexture(unsigned role) {
    g_texels.clear();
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            const glm::vec4 value = texel(static_cast<TextureRole>(role), placeOf(x, y));
            for (int channel = 0; channel < 4; ++channel)
                g_texels.push_back(
                    static_cast<std::uint8_t>(std::lround(255 * glm::clamp(value[channel], 0.0f, 1.0f))));
        }
    Json json;
    json.begin('{').member("width", kSize).member("height", kSize);
    writeArray(json, "rgba", g_texels, 1);
    answer(json.end('}'));
}
