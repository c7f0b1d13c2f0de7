// SPDX-License-Identifier: MIT
#include "franken/reflection.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/ext/vector_float2.hpp>
#include <glm/geometric.hpp>

#include "helper_threads.h"

namespace franken {
namespace {

constexpr int kSamples = 512;

/// `count` points, evenly over the unit square (Hammersley).
std::vector<glm::vec2> evenPoints(int count) {
    std::vector<glm::vec2> points;
    for (int i = 0; i < count; ++i) {
        float radical = 0, digit = 0.5f;
        for (int rest = i; rest > 0; rest /= 2, digit *= 0.5f)
            radical += static_cast<float>(rest % 2) * digit;
        points.emplace_back((static_cast<float>(i) + 0.5f) / static_cast<float>(count), radical);
    }
    return points;
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
/// over five skies (generator/docs/sky.md), for metals and dielectrics at once.
float levelOf(float nDotV, float roughness) {
    const float level = 2 * std::log2(roughness) + kReflectionLevels - 1;
    const float sharper =
        (1 - nDotV) * (0.53f + roughness * (5.17f - roughness * (4.0f + 1.06f * roughness)));
    return std::max(level - sharper, 0.0f);
}

/// The share of the light that is taken from the sky's irradiance instead: the broad part of a lobe that is
/// seen at an angle.
float irradianceShare(float nDotV, float roughness) {
    const float share = 2.68f - 1.9f * roughness - nDotV * (2.97f - 3.57f * roughness);
    return std::clamp(roughness * roughness * roughness * share, 0.0f, 1.0f);
}

std::uint8_t toCode(float value) {
    return static_cast<std::uint8_t>(255 * std::clamp(value, 0.0f, 1.0f) + 0.5f);
}

} // namespace

Image reflectionLookup() {
    Image image{"", kLookupWidth, kLookupHeight,
                std::vector<std::uint8_t>(std::size_t{4} * kLookupWidth * kLookupHeight)};
    const std::vector<glm::vec2> points = evenPoints(kSamples);
    forEachRow(kLookupHeight,
               [&](int y) {
                   const float roughness = (static_cast<float>(y) + 0.5f) / kLookupHeight;
                   std::uint8_t* texel = &image.rgba[static_cast<std::size_t>(4 * kLookupWidth * y)];
                   for (int x = 0; x < kLookupWidth; ++x, texel += 4) {
                       const float nDotV = (static_cast<float>(x) + 0.5f) / kLookupWidth;
                       const glm::vec2 light = reflected(nDotV, roughness, points);
                       texel[0] = toCode(light.x);
                       texel[1] = toCode(light.y);
                       texel[2] = toCode(levelOf(nDotV, roughness) / (kReflectionLevels - 1));
                       texel[3] = toCode(irradianceShare(nDotV, roughness));
                   }
               },
               {});
    return image;
}

} // namespace franken
