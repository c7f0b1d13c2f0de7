// SPDX-License-Identifier: MIT
#include "sky_shader.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include "sky_sampling.h"

namespace franken::test {
namespace {

constexpr float kRatio = 0.70710678f, kHeight = (1 - 0.0625f * kRatio) / (1 - kRatio);

} // namespace

glm::vec4 sample(const Image& image, const glm::vec2& uv) {
    const glm::vec2 point = uv * glm::vec2(image.width, image.height) - 0.5f;
    const glm::vec2 corner = glm::floor(point), weight = point - corner;
    const auto texel = [&](int dx, int dy) {
        const int x = std::clamp(static_cast<int>(corner.x) + dx, 0, image.width - 1);
        const int y = std::clamp(static_cast<int>(corner.y) + dy, 0, image.height - 1);
        const std::uint8_t* rgba = &image.rgba[static_cast<std::size_t>(4 * (y * image.width + x))];
        return glm::vec4(rgba[0], rgba[1], rgba[2], rgba[3]) / 255.0f;
    };
    return glm::mix(glm::mix(texel(0, 0), texel(1, 0), weight.x),
                    glm::mix(texel(0, 1), texel(1, 1), weight.x), weight.y);
}

glm::vec3 skyLight(const ReflectionAtlas& atlas, const glm::vec3& n) {
    const glm::vec2 p = glm::vec2(n.x, n.z) * (1 - 0.5f * std::abs(n.y)) * kAtlasInner;
    const glm::vec4 texel = sample(atlas.image, {p.x / 16 + (n.y < 0 ? 0.9375f : 0.8125f), p.y / 16 + 0.75f});
    const glm::vec3 root = glm::vec3(texel) * texel.a;
    return root * root * atlas.range;
}

glm::vec3 skyThroughLobe(const ReflectionAtlas& atlas, const glm::vec3& d, float level) {
    const glm::vec2 p =
        glm::vec2(d.x, d.z) / (std::max(std::abs(d.x), std::abs(d.z)) + std::abs(d.y)) * kAtlasInner;
    const auto root = [&](float index) {
        const float size = std::pow(kRatio, index), top = (1 - size) / (1 - kRatio);
        const glm::vec2 uv(size * (0.25f * p.x + (d.y < 0 ? 0.75f : 0.25f)),
                           (top + size * (0.5f * p.y + 0.5f)) / kHeight);
        const glm::vec4 texel = sample(atlas.image, uv);
        return glm::vec3(texel) * texel.a;
    };
    const float whole = std::floor(level);
    const glm::vec3 mean = glm::mix(root(whole), root(whole + 1), level - whole);
    return mean * mean * atlas.range;
}

glm::vec3 SkyMaterial::f0() const { return glm::mix(glm::vec3(0.04f), baseColor, metallic); }

const std::vector<SkyMaterial>& skyMaterials() {
    static const std::vector<SkyMaterial> materials = {{"coloured metal", {0.9f, 0.5f, 0.2f}, 1},
                                                       {"white metal", glm::vec3(1), 1},
                                                       {"grey dielectric", glm::vec3(0.5f), 0},
                                                       {"black dielectric", glm::vec3(0), 0}};
    return materials;
}

glm::vec3 reflectedByShader(const ReflectionMaps& sky, const glm::vec3& n, const glm::vec3& v,
                            float roughness, const SkyMaterial& material) {
    const float nDotV = std::max(glm::dot(n, v), 1e-4f);
    const glm::vec4 look = sample(sky.lookup, {nDotV, roughness});
    const float bend = reflectionBend(roughness, material.metallic);
    const glm::vec3 toSky = n * (2 * nDotV + bend * (1 - nDotV)) - v;
    const glm::vec3 mirrored = glm::mix(skyThroughLobe(sky.atlas, toSky, (kReflectionLevels - 1) * look.b),
                                        skyLight(sky.atlas, n), look.a);
    return mirrored * (material.f0() * look.r + look.g);
}

glm::dvec3 irradianceByCoefficients(const LightsBlock& lights, const glm::vec3& n) {
    const float basis[9] = {
        1, n.y, n.z, n.x, n.x * n.y, n.y * n.z, 3 * n.z * n.z - 1, n.x * n.z, n.x * n.x - n.y * n.y};
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < 9; ++i)
        sum += glm::dvec3(lights.ambient.sky[i][0], lights.ambient.sky[i][1], lights.ambient.sky[i][2]) *
               static_cast<double>(basis[i]);
    return sum * static_cast<double>(kDielectricScatters);
}

glm::vec3 codes(const glm::vec3& color) {
    const glm::vec3 c = glm::clamp(color, 0.0f, 1.0f);
    glm::vec3 result;
    for (int i = 0; i < 3; ++i)
        result[i] = 255 * (c[i] < 0.0031308f ? 12.92f * c[i] : 1.055f * std::pow(c[i], 1 / 2.4f) - 0.055f);
    return result;
}

double meanDifference(const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 d = glm::abs(codes(a) - codes(b));
    return static_cast<double>(d.r + d.g + d.b) / 3;
}

double goal(const SkyError& error) { return error.nDotV > 0.5f ? 3 : 6; }

std::vector<SkyError> skyErrors(const Environment& sky, int orientations) {
    const ReflectionMaps reflection{filterReflection(sky), reflectionLookup()};
    const std::vector<SkyMaterial>& materials = skyMaterials();
    const std::vector<glm::vec3> normals = directions(orientations);
    std::vector<SkyError> errors;
    for (const float nDotV : {1.0f, 0.2f})
        for (const float roughness : {0.2f, 0.4f, 0.6f, 0.8f, 1.0f}) {
            std::vector<double> sums(materials.size());
            for (std::size_t i = 0; i < normals.size(); ++i) {
                const Frame frame(normals[i], static_cast<float>(i));
                const glm::vec3 v = frame.toWorld({std::sqrt(1 - nDotV * nDotV), 0, nDotV});
                const Reflected truth = reflected(sky, frame, nDotV, roughness);
                const glm::vec3 irradiance = skyLight(reflection.atlas, frame.z);
                for (std::size_t m = 0; m < materials.size(); ++m) {
                    const SkyMaterial& material = materials[m];
                    const glm::vec3 scattered =
                        0.96f * (1 - material.metallic) * material.baseColor * irradiance;
                    sums[m] += meanDifference(
                        scattered + reflectedByShader(reflection, frame.z, v, roughness, material),
                        scattered + material.f0() * truth.byF0 + truth.besides);
                }
            }
            for (std::size_t m = 0; m < materials.size(); ++m)
                errors.push_back({nDotV, roughness, materials[m].name, sums[m] / orientations});
        }
    return errors;
}

} // namespace franken::test
