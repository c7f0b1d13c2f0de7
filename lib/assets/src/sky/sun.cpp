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

/// Calls visit(texel, unit direction, solid angle) for all texels.
template<typename Texels, typename Visit>
void forEachTexel(const Environment& sky, Texels& texels, const Visit& visit) {
    for (int y = 0; y < sky.height; ++y)
        for (int x = 0; x < sky.width; ++x)
            visit(texels[static_cast<std::size_t>(y) * sky.width + x],
                  texelDirection(sky, static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f),
                  texelSolidAngle(sky, x, y));
}

Brightest findBrightest(const Environment& sky) {
    Brightest found;
    forEachTexel(sky, sky.texels, [&](const glm::vec3& texel, const glm::vec3& direction, double solidAngle) {
        found.mean += brightness(texel) * solidAngle / (4 * std::numbers::pi);
        if (brightness(texel) > found.peak) {
            found.peak = brightness(texel);
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
    forEachTexel(sky, sky.texels, [&](glm::vec3& texel, const glm::vec3& direction, double solidAngle) {
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
    return Sun{{travels.x, travels.y, travels.z}, {color.r, color.g, color.b}, static_cast<float>(most)};
}

} // namespace franken
