// SPDX-License-Identifier: MIT
#include "franken/generator/ambient.h"

#include "numbers.h"
#include "pack_fields.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace franken {
namespace {

// Ramamoorthi and Hanrahan 2001: E(n) = sum A_l L_lm Y_lm(n) with A = pi, 2 pi / 3, pi / 4. The factors
// below are A_l / pi times the constant of Y_lm.
std::array<Float3, 9> packSky(const SkyCoefficients& sky, float exposure) {
    constexpr Float9 kFactors = {0.28209479f,         0.48860251f * 2 / 3, 0.48860251f * 2 / 3,
                                 0.48860251f * 2 / 3, 1.09254843f / 4,     1.09254843f / 4,
                                 0.31539157f / 4,     1.09254843f / 4,     0.54627422f / 4};
    std::array<Float3, 9> polynomial;
    for (std::size_t i = 0; i < sky.size(); ++i)
        polynomial[i] = scaled(sky[i], kFactors[i] * exposure / kDielectricScatters);
    return polynomial;
}

double brightestSide(const std::array<Float3, 9>& polynomial) {
    const auto at = [&polynomial](std::size_t i) { return luminance(polynomial[i]); };
    const double x = std::abs(at(3)) + at(0) - at(6) + at(8), y = std::abs(at(1)) + at(0) - at(6) - at(8),
                 z = std::abs(at(2)) + at(0) + 2 * at(6);
    return std::max({x, y, z, 0.0});
}

constexpr PackField kFields[] = {
    {Block::Lights, "uAmbient", offsetof(LightsBlock, ambient) + offsetof(AmbientBlock, color)},
    {Block::Lights, "uSky", offsetof(LightsBlock, ambient) + offsetof(AmbientBlock, sky)},
};

} // namespace

std::span<const PackField> ambientFields() { return kFields; }

void fitToFp16(AmbientBlock& block) {
    limit(block.color, kMostRadianceFp16);
    for (Float3& coefficient : block.sky)
        limit(coefficient, kMostRadianceFp16);
}

std::optional<LightFault> faultOf(const AmbientLight& light) {
    if (!isAmount(light.color))
        return LightFault{"color", kAmountRule};
    if (!std::all_of(light.sky.begin(), light.sky.end(), areFinite<Float3>))
        return LightFault{"sky", "its coefficients must be finite"};
    return std::nullopt;
}

double brightestSide(const AmbientLight& light) {
    switch (light.kind) {
    case Ambient::None:
        return 0;
    case Ambient::Color:
        return luminance(light.color);
    case Ambient::Sky:
        return brightestSide(packSky(light.sky, kDielectricScatters));
    }
    return 0;
}

AmbientBlock packAmbient(const AmbientLight& light, float exposure) {
    AmbientBlock block{};
    switch (light.kind) {
    case Ambient::None:
        break;
    case Ambient::Color:
        block.color = scaled(light.color, exposure);
        break;
    case Ambient::Sky:
        block.sky = packSky(light.sky, exposure);
        break;
    }
    return block;
}

AmbientBlock packEvenAmbient(float radiance) {
    AmbientBlock block{};
    block.color.fill(radiance);
    block.sky[0] = block.color;
    return block;
}

} // namespace franken
