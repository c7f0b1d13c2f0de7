// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "sky/sky.h"
#include "sky/filter.h"

namespace franken {
namespace {

constexpr float kRatio = 0.70710678f; ///< Of a level's size to that of the one before.
constexpr float kHeight = (1 - 0.0625f * kRatio) / (1 - kRatio); ///< Of all levels, in sizes of the first.
constexpr int kLookupSamples = 512;

constexpr int kIrradiance = kSpecularLevels; ///< After the levels of the lobes.
constexpr float kIrradianceRow = 0.75f;      ///< Where its middle is, of the atlas's height.

struct AtlasPoint {
    int level = 0;
    glm::vec3 direction{0};
};

/// The direction d, in the upper half of the sphere or a little below, that lies at p = (d.x, d.z) (1 - d.y /
/// 2). |p| falls from 1.1 where d.y is -0.366, to which points beyond belong, to 0 where it is 1.
glm::vec3 irradianceDirection(const glm::vec2& p) {
    const float radius = glm::length(p);
    float below = -0.366f, above = 1;
    for (int halving = 0; halving < 24; ++halving) {
        const float y = 0.5f * (below + above);
        (std::sqrt(1 - y * y) * (1 - 0.5f * y) > radius ? below : above) = y;
    }
    const float scale = 1 - 0.5f * below;
    return glm::normalize(glm::vec3(p.x / scale, below, p.y / scale));
}

/// The irradiance: two rectangles right of the smaller levels, an eighth of the atlas wide and high.
std::optional<AtlasPoint> irradiancePoint(float u, float v) {
    if (u < 0.75f || std::abs(v - kIrradianceRow) > 0.0625f)
        return std::nullopt;
    const bool upper = u < 0.875f;
    const glm::vec2 p(16 * (u - (upper ? 0.8125f : 0.9375f)), 16 * (v - kIrradianceRow));
    glm::vec3 direction = irradianceDirection(p / kSpecularScale);
    direction.y = upper ? direction.y : -direction.y;
    return AtlasPoint{kIrradiance, direction};
}

/// What a point of the atlas holds; nothing beside the squares. u, v: 0 to 1.
std::optional<AtlasPoint> atlasPoint(float u, float v) {
    if (const auto irradiance = irradiancePoint(u, v))
        return irradiance;
    AtlasPoint point;
    float size = 1, top = 0;
    while (point.level + 1 < kSpecularLevels && v * kHeight >= top + size) {
        top += size;
        size *= kRatio;
        ++point.level;
    }
    if (u >= size)
        return std::nullopt;
    const bool upper = u < 0.5f * size;
    const float s = 4 * u / size - (upper ? 1 : 3), t = 2 * (v * kHeight - top) / size - 1;
    const glm::vec2 p = glm::vec2(s, t) / kSpecularScale;
    const float y = 1 - std::max(std::abs(p.x), std::abs(p.y));
    point.direction = glm::normalize(glm::vec3(p.x, upper ? y : -y, p.y));
    return point;
}

/// A microfacet's normal, distributed as those that the eye sees (Dupuy and Benyoub, "Sampling Visible GGX
/// Normals with Spherical Caps", 2023). v: towards the eye.
glm::vec3 visibleMicrofacet(const glm::vec2& point, const glm::vec3& v, float alpha) {
    const glm::vec3 stretched = glm::normalize(glm::vec3(alpha * v.x, alpha * v.y, v.z));
    const float z = (1 - point.x) * (1 + stretched.z) - stretched.z;
    const float ring = std::sqrt(std::max(1 - z * z, 0.0f)), angle = 2 * std::numbers::pi_v<float> * point.y;
    const glm::vec3 half = glm::vec3(ring * std::cos(angle), ring * std::sin(angle), z) + stretched;
    return glm::normalize(glm::vec3(alpha * half.x, alpha * half.y, half.z));
}

/// Smith's lambda for GGX, plus a half.
float smithLambda(float cosine, float alpha) {
    const float tangent2 = 1 / (cosine * cosine) - 1;
    return 0.5f * std::sqrt(1 + alpha * alpha * tangent2);
}

/// How much of a white sky is reflected: by what the surface reflects at normal incidence, and besides.
glm::vec2 reflected(float nDotV, float roughness, const std::vector<glm::vec2>& points) {
    const float alpha = roughness * roughness;
    const glm::vec3 v(std::sqrt(1 - nDotV * nDotV), 0, nDotV);
    const float lambdaV = smithLambda(nDotV, alpha);
    glm::vec2 sum(0);
    for (const glm::vec2& point : points) {
        const glm::vec3 half = visibleMicrofacet(point, v, alpha);
        const float vDotH = glm::dot(v, half), nDotL = 2 * vDotH * half.z - nDotV;
        if (nDotL <= 0)
            continue;
        const float weight = (lambdaV + 0.5f) / (lambdaV + smithLambda(nDotL, alpha));
        const float fresnel = std::pow(1 - std::min(vDotH, 1.0f), 5.0f);
        sum += weight * glm::vec2(1 - fresnel, fresnel);
    }
    return sum / static_cast<float>(points.size());
}

/// The level to look at. A lobe that is seen at an angle is narrow across the plane of N and V: so the level
/// is sharper than what the roughness alone asks for. This and the share below were fitted to brute force
/// over two skies, for a white and a coloured metal and a black dielectric at once.
float levelOf(float nDotV, float roughness) {
    const float level = 2 * std::log2(roughness) + kSpecularLevels - 1;
    const float sharper =
        (1 - nDotV) * (1 - roughness) * (1.08f + 1.22f * roughness + 7.6f * roughness * roughness);
    return std::max(level - sharper, 0.0f);
}

/// The share of the light that is taken from the sky's irradiance instead: the broad part of a lobe that is
/// seen at an angle.
float irradianceShare(float nDotV, float roughness) {
    const float share = 1.1f - 0.32f * roughness - nDotV * (2.31f - 2.91f * roughness);
    return std::clamp(roughness * roughness * share, 0.0f, 1.0f);
}

std::uint8_t toCode(float value) {
    return static_cast<std::uint8_t>(255 * std::clamp(value, 0.0f, 1.0f) + 0.5f);
}

} // namespace

int specularHeight(int size) { return static_cast<int>(std::ceil(kHeight * static_cast<float>(size))); }

SpecularAtlas filterSpecular(const Environment& sky, int size, const Progress& progress) {
    assert(size >= kMinSpecularSize && size <= kMaxSpecularSize);
    const SkyFilter filter(sky);
    std::array<std::vector<SkyFilter::Sample>, kSpecularLevels + 1> lobes;
    for (int i = 0; i < kSpecularLevels; ++i)
        lobes[static_cast<std::size_t>(i)] =
            filter.lobe(std::exp2(0.5f * static_cast<float>(i + 1 - kSpecularLevels)));
    lobes[kIrradiance] = filter.cosineLobe();

    const int width = 2 * size, height = specularHeight(size);
    std::vector<glm::vec3> texels(std::size_t{1} * width * height);
    forEachRow(
        height,
        [&](int y) {
            for (int x = 0; x < width; ++x) {
                const auto point = atlasPoint((static_cast<float>(x) + 0.5f) / static_cast<float>(width),
                                              (static_cast<float>(y) + 0.5f) / static_cast<float>(height));
                if (point)
                    texels[static_cast<std::size_t>(y) * width + x] =
                        filter.radiance(lobes[static_cast<std::size_t>(point->level)], point->direction);
            }
        },
        progress);
    SpecularAtlas atlas;
    atlas.range = rangeOf(texels);
    atlas.image = encodeRgbm(texels, width, height, atlas.range);
    return atlas;
}

Image specularLookup() {
    Image image{"", kLookupWidth, kLookupHeight,
                std::vector<std::uint8_t>(std::size_t{4} * kLookupWidth * kLookupHeight)};
    const std::vector<glm::vec2> points = evenPoints(kLookupSamples);
    forEachRow(kLookupHeight,
               [&](int y) {
                   const float roughness = (static_cast<float>(y) + 0.5f) / kLookupHeight;
                   std::uint8_t* texel = &image.rgba[static_cast<std::size_t>(4 * kLookupWidth * y)];
                   for (int x = 0; x < kLookupWidth; ++x, texel += 4) {
                       const float nDotV = (static_cast<float>(x) + 0.5f) / kLookupWidth;
                       const glm::vec2 light = reflected(nDotV, roughness, points);
                       texel[0] = toCode(light.x);
                       texel[1] = toCode(light.y);
                       texel[2] = toCode(levelOf(nDotV, roughness) / (kSpecularLevels - 1));
                       texel[3] = toCode(irradianceShare(nDotV, roughness));
                   }
               },
               {});
    return image;
}

} // namespace franken
