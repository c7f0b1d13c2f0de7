// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numbers>

#include <glm/geometric.hpp>

#include "sky/sky.h"

namespace franken {
namespace {

constexpr float kCosReach = 0.9962f; ///< Of 5 degrees.

float brightness(const glm::vec3& radiance) { return std::max({radiance.r, radiance.g, radiance.b}); }

struct Brightest {
    double mean = 0; ///< Over the sphere.
    float peak = 0;
    glm::vec3 direction{0, 1, 0};
};

/// The index of the texel that a point lies in.
std::size_t texelIndex(const Environment& sky, const glm::vec2& point) {
    return static_cast<std::size_t>(point.y) * static_cast<std::size_t>(sky.width) +
           static_cast<std::size_t>(point.x);
}

Brightest findBrightest(const Environment& sky) {
    Brightest found;
    forEachPart(sky, 1, [&](const glm::vec2& point, const glm::vec3& direction, double solidAngle) {
        const float bright = brightness(sky.texels[texelIndex(sky, point)]);
        found.mean += bright * solidAngle / (4 * std::numbers::pi);
        if (bright > found.peak) {
            found.peak = bright;
            found.direction = direction;
        }
    });
    return found;
}

} // namespace

std::optional<Sun> takeSun(Environment& sky) {
    const Brightest brightest = findBrightest(sky);
    const float limit = kSunContrast * static_cast<float>(brightest.mean);
    if (brightest.peak <= limit)
        return std::nullopt;

    glm::dvec3 irradiance(0), middle(0);
    forEachPart(sky, 1, [&](const glm::vec2& point, const glm::vec3& direction, double solidAngle) {
        glm::vec3& texel = sky.texels[texelIndex(sky, point)];
        if (brightness(texel) <= limit || glm::dot(direction, brightest.direction) < kCosReach)
            return;
        const glm::vec3 kept = texel * (limit / brightness(texel));
        const glm::dvec3 taken = glm::dvec3(texel - kept) * solidAngle;
        irradiance += taken;
        middle += glm::dvec3(direction) * (taken.r + taken.g + taken.b);
        texel = kept;
    });
    const double most = std::max({irradiance.r, irradiance.g, irradiance.b});
    const glm::vec3 travels = -glm::normalize(middle), color = irradiance / most;
    return Sun{.direction = {travels.x, travels.y, travels.z},
               .color = {color.r, color.g, color.b},
               .illuminance = static_cast<float>(most),
               .ofSky = true};
}

} // namespace franken
