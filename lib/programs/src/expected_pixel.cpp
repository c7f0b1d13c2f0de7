// SPDX-License-Identifier: MIT
#include "expected_pixel.h"

#include "franken/generator/pack.h"

#include <algorithm>
#include <cmath>

namespace franken {
namespace {

using Color = std::array<float, 3>;
using Scene = ProbeScene;

constexpr Color grey(float value) { return {value, value, value}; }

bool isLit(const Permutation& p) {
    return p.program == Program::Surface && p.view == View::Shaded && p.shading == Shading::Lit;
}

/// 1 / E - 1 of the scene, where the program gives that back.
float compensation(const Permutation& p) {
    if (!p.energy)
        return 0;
    constexpr float kLookup =
        2; // The white texels' share, which only a program of the sky's reflection reads.
    return p.reflection != Reflection::None ? 1 / kLookup - 1 : energyCompensation(1, Scene::kRoughness);
}

/// Of specular light, of which F0 `scale` + `bias` is reflected: a metal's and a dielectric's share.
float specular(const Permutation& p, float base, float scale, float bias) {
    const auto layer = [&](float f0) { return (f0 * scale + bias) * (1 + f0 * compensation(p)); };
    return Scene::kMetallic * layer(base) + (1 - Scene::kMetallic) * layer(0.04f);
}

/// What a surface reflects of one light: pi D V is 1 / (4 alpha^2), and Schlick's term 0.
float reflectedLight(const Permutation& p, float base) {
    constexpr float kAlpha = Scene::kRoughness * Scene::kRoughness, kLobe = 1 / (4 * kAlpha * kAlpha);
    constexpr float kMetal = Scene::kMetallic, kDielectric = 0.04f * (1 - kMetal);
    if (p.brdf == Brdf::Seed) // One F_0, which takes its share of the scattered light from each channel.
        return (1 - kMetal) * (1 - kDielectric - kMetal * base) * base +
               (kMetal * base + kDielectric) * kLobe;
    return specular(p, base, kLobe, 0) + 0.96f * (1 - kMetal) * base;
}

/// The lookup's texels are white: F_0 and 1 are reflected, all of it irradiance.
float ambientLight(const Permutation& p, float base) {
    constexpr float kMetal = Scene::kMetallic;
    if (p.reflection != Reflection::None)
        return Scene::kAmbient * (specular(p, base, 1, 1) + 0.96f * (1 - kMetal) * base);
    if (p.ambient == Ambient::None)
        return 0;
    return Scene::kAmbient * base * (dependsOnNormal(p.ambient) ? 0.96f * (1 - kMetal) : 1);
}

Color litColor(const Permutation& p) {
    Color color{};
    for (std::size_t i = 0; i < color.size(); ++i) {
        color[i] = ambientLight(p, Scene::kBase[i]);
        color[i] += Scene::kLight * static_cast<float>(p.suns + p.punctualLights) *
                    reflectedLight(p, Scene::kBase[i]);
        color[i] += p.emissive == Emissive::None ? 0 : Scene::kEmissive;
    }
    return color;
}

/// Khronos PBR Neutral tone mapper, 2024.
Color neutral(Color c) {
    const float low = *std::min_element(c.begin(), c.end());
    const float offset = low < 0.08f ? low - 6.25f * low * low : 0.04f;
    for (float& channel : c)
        channel -= offset;
    const float peak = *std::max_element(c.begin(), c.end());
    if (peak <= 0.76f)
        return c;
    const float compressed = 1 - 0.0576f / (peak - 0.52f);
    const float fade = 1 / (0.15f * (peak - compressed) + 1);
    for (float& channel : c)
        channel = compressed + (channel * compressed / peak - compressed) * fade;
    return c;
}

Color toneMapped(ToneMap map, Color c) {
    const auto each = [&c](auto function) { std::transform(c.begin(), c.end(), c.begin(), function); };
    switch (map) {
    case ToneMap::None:
        break;
    case ToneMap::Reinhard:
        each([](float x) { return x / (1 + x); });
        break;
    case ToneMap::Aces:
        each([](float x) { return x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f); });
        break;
    case ToneMap::Neutral:
        return neutral(c);
    }
    return c;
}

float encoded(Output output, float c) {
    switch (output) {
    case Output::Linear:
        return c;
    case Output::Pow22:
        return std::pow(c, 1 / 2.2f);
    default:
        return c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1 / 2.4f) - 0.055f;
    }
}

Color viewed(const Permutation& p) {
    switch (p.view) {
    case View::Normal:
        return {0.5f, 0.5f, 1};
    case View::RoughnessMetallic:
        return {0, Scene::kRoughness, Scene::kMetallic};
    default:
        return grey(1);
    }
}

/// In codes over 255, for a target that does not encode.
Color expected(const Permutation& p) {
    if (p.program == Program::Overlay)
        return Scene::kBase;
    if (p.program == Program::Surface && p.view != View::Shaded && p.view != View::BaseColor)
        return viewed(p);
    Color color = p.program == Program::Sky ? grey(Scene::kSkybox) : isLit(p) ? litColor(p) : Scene::kBase;
    if (p.program == Program::Sky || isLit(p))
        color = toneMapped(p.toneMap, color);
    for (float& channel : color)
        channel = encoded(p.output, std::max(channel, 0.0f));
    return color;
}

bool isNear(const Color& color, const std::array<std::uint8_t, 4>& pixel) {
    for (std::size_t i = 0; i < color.size(); ++i) {
        const float code = 255 * std::clamp(color[i], 0.0f, 1.0f);
        if (std::abs(static_cast<float>(pixel[i]) - code) > 8 + code / 8)
            return false;
    }
    return true;
}

} // namespace

bool isExpected(const Permutation& permutation, const std::array<std::uint8_t, 4>& pixel) {
    Color color = expected(permutation);
    if (isNear(color, pixel))
        return true;
    std::transform(color.begin(), color.end(), color.begin(),
                   [](float c) { return encoded(Output::Srgb, c); });
    return permutation.output == Output::Linear && isNear(color, pixel);
}

} // namespace franken
