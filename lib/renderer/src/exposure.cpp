// SPDX-License-Identifier: MIT
#include "franken/exposure.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace franken {

float autoExposure(const Lighting& lighting, const Box& bounds) {
    double light = std::numbers::pi * brightestSide(lighting.ambient); // lux
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
