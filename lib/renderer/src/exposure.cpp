// SPDX-License-Identifier: MIT
#include "franken/exposure.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace franken {
namespace {

// Rec. ITU-R BT.709, of linear colours.
double luminance(const Float3& color) { return 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2]; }

/// Irradiance over pi along +-X, +-Y and +-Z, the most of them: the polynomial that packSky() folds.
double brightestSide(const SkyCoefficients& sky) {
    LightsBlock block{};
    packSky(block, sky, kDielectricScatters);
    const auto at = [&block](std::size_t i) { return luminance(block.sky[i]); };
    const double x = std::abs(at(3)) + at(0) - at(6) + at(8), y = std::abs(at(1)) + at(0) - at(6) - at(8),
                 z = std::abs(at(2)) + at(0) + 2 * at(6);
    return std::max({x, y, z, 0.0});
}

double ambientOf(const Lighting& lighting) {
    switch (lighting.ambient) {
    case Ambient::None:
        return 0;
    case Ambient::Color:
        return luminance(lighting.ambientColor);
    case Ambient::Sky:
        return brightestSide(lighting.sky);
    }
    return 0;
}

} // namespace

float autoExposure(const Lighting& lighting, const Box& bounds) {
    double light = std::numbers::pi * ambientOf(lighting); // lux
    for (const Sun& sun : lighting.suns)
        light += luminance(sun.color) * sun.illuminance;
    const glm::dvec3 center = bounds.empty() ? glm::dvec3(0) : 0.5 * (bounds.min + bounds.max);
    const double radius = bounds.empty() ? 0 : 0.5 * glm::distance(bounds.min, bounds.max);
    for (const PunctualLight& punctual : lighting.punctualLights) {
        const glm::dvec3 place(punctual.position[0], punctual.position[1], punctual.position[2]);
        const double distance = std::max({glm::distance(place, center), radius, 1e-3});
        light += luminance(punctual.color) * punctual.intensity / (distance * distance);
    }
    return light > 0 ? static_cast<float>(std::numbers::pi / light) : 1.0f;
}

} // namespace franken
