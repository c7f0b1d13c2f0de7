// SPDX-License-Identifier: MIT
// The page's own sphere, and a texture for each role of its material.
#include "exchange.h"
#include "franken/complete.h"
#include "franken/generator/texture_role.h"
#include "write_primitive.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

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

/// Where a texel lies: in which tile, and from -1 to 1 within it.
struct Place {
    int column, row;
    glm::vec2 inTile;
};

Place placeOf(int x, int y) {
    const glm::vec2 tile = (glm::vec2(x, y) + 0.5f) * (static_cast<float>(kTiles) / kSize);
    const glm::vec2 corner = glm::floor(tile);
    return {static_cast<int>(corner.x), static_cast<int>(corner.y), 2.0f * (tile - corner) - 1.0f};
}

bool isDark(const Place& place) { return (place.column + place.row) % 2 != 0; }

glm::vec4 baseColor(const Place& place) {
    const float alpha = glm::length(place.inTile) < 0.6f || isDark(place) ? 1 : 0.3f;
    return isDark(place) ? glm::vec4(0.55f, 0.6f, 0.68f, alpha) : glm::vec4(0.95f, 0.9f, 0.8f, alpha);
}

/// Each tile is a shallow bump.
glm::vec4 normal(const Place& place) {
    const glm::vec2 slope =
        0.5f * place.inTile * (1.0f - glm::smoothstep(0.6f, 1.0f, glm::length(place.inTile)));
    return {0.5f + 0.5f * glm::normalize(glm::vec3(slope.x, -slope.y, 1)), 1};
}

float occlusion(const Place& place) {
    return glm::smoothstep(0.0f, 0.4f, 1 - std::max(std::abs(place.inTile.x), std::abs(place.inTile.y)));
}
float roughness(const Place& place) { return static_cast<float>(place.row + 1) / kTiles; }
float metalness(const Place& place) { return isDark(place) ? 1 : 0; }

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
        return glm::vec4(glm::vec3(glm::length(place.inTile) < 0.4f && !isDark(place) ? 1.0f : 0.0f), 1);
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
        g_sphere.uv[1].push_back(2.0f * g_sphere.uv[0][i]);
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
