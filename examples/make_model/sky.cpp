// SPDX-License-Identifier: MIT
#include "sky.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

#include <glm/glm.hpp>

#include "franken/file_writer.h"
#include "numbers.h"

namespace make_model {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kSamples = 2; ///< A texel, along each side.

const glm::dvec3 kSun = glm::normalize(glm::dvec3(-0.86, 0.16, -0.5));
constexpr glm::dvec3 kZenith(0.06, 0.13, 0.33), kRose(0.50, 0.40, 0.52), kGold(1.65, 0.82, 0.34);

/// Linear radiance by direction (+Y up). Air, where it is dusk: gold towards the sun, rose away from it, blue
/// above; without the sun's disc.
glm::dvec3 air(const glm::dvec3& d) {
    const double around =
        glm::dot(glm::normalize(glm::dvec2(d.x, d.z)), glm::normalize(glm::dvec2(kSun.x, kSun.z)));
    const double near = 0.5 + 0.5 * around;
    const glm::dvec3 horizon = glm::mix(kRose, kGold, near * near * near);
    const double toSun = 1 - glm::dot(d, kSun);
    return glm::mix(kZenith, horizon, std::exp(-4.5 * d.y)) + kGold * (0.8 * std::exp(-18 * toSun)) +
           glm::dvec3(4, 2.6, 1.4) * std::exp(-400 * toSun);
}

/// Bands of cloud, lit from below where the sun is near.
glm::dvec3 clouds(const glm::dvec3& d, const glm::dvec3& behind) {
    const glm::dvec2 place = glm::dvec2(0.7 * d.x, 2.2 * d.z) / (d.y + 0.12);
    const double thick = ramp(0.46, 0.78, cloud(place + 100.0, 256, 7)) * ramp(0.03, 0.2, d.y);
    const double lit = std::exp(-2.2 * (1 - glm::dot(d, kSun)));
    const glm::dvec3 color = glm::mix(glm::dvec3(0.24, 0.22, 0.33), glm::dvec3(2.4, 1.2, 0.62), lit);
    return glm::mix(behind, color, 0.8 * thick);
}

/// Everything above the water.
glm::dvec3 above(const glm::dvec3& d) {
    const double turn = std::atan2(d.x, -d.z) / (2 * kPi) + 0.5;
    const double trees =
        0.005 * noise({900 * turn, 0.5}, 900, 23) + 0.003 * noise({2400 * turn, 0.5}, 2400, 29);
    const double near = 0.008 + 0.05 * cloud({24 * turn, 0.5}, 24, 3) + trees;
    const double far = 0.02 + 0.075 * cloud({12 * turn, 7.5}, 12, 5);
    const glm::dvec3 sky = air(d);
    if (d.y < near)
        return glm::mix(glm::dvec3(0.035, 0.05, 0.07), sky, 0.18);
    if (d.y < far)
        return glm::mix(glm::dvec3(0.10, 0.11, 0.18), sky, 0.4);
    return clouds(d, sky);
}

/// The lake, a metre below: what is above in its ripples, by Fresnel's share, and the dark under them.
glm::dvec3 water(const glm::dvec3& d) {
    const glm::dvec2 place = glm::dvec2(d.x, d.z) / -d.y;
    const double calm = 0.09 / (1 + 0.15 * glm::length(place));
    const double tiltX = cloud(glm::dvec2(3, 5) * place + 300.0, 1024, 11) - 0.5;
    const double tiltZ = cloud(glm::dvec2(3, 5) * place + 700.0, 2048, 13) - 0.5;
    const glm::dvec3 normal = glm::normalize(glm::dvec3(calm * tiltX, 1, 2 * calm * tiltZ));
    glm::dvec3 mirrored = glm::reflect(d, normal);
    mirrored.y = std::max(mirrored.y, 0.002);
    const double x = 1 - std::max(-glm::dot(d, normal), 0.0);
    const double share = 0.02 + 0.98 * x * x * x * x * x;
    return glm::mix(glm::dvec3(0.02, 0.05, 0.075), above(glm::normalize(mirrored)), share);
}

std::array<std::uint8_t, 4> toRgbe(const glm::dvec3& radiance) {
    int exponent = 0;
    const double most = std::max({radiance.r, radiance.g, radiance.b});
    const double scale = std::frexp(most, &exponent) * 256 / most;
    const auto mantissa = [scale](double channel) { return static_cast<std::uint8_t>(channel * scale); };
    return {mantissa(radiance.r), mantissa(radiance.g), mantissa(radiance.b),
            static_cast<std::uint8_t>(exponent + 128)};
}

glm::dvec3 skyRadiance(const glm::dvec3& direction) {
    if (direction.y < 0)
        return water(direction);
    const bool disc = glm::dot(direction, kSun) > 0.99990; // 0.8 degrees: a few texels.
    return above(direction) + (disc ? glm::dvec3(2400, 1400, 680) : glm::dvec3(0));
}

glm::dvec3 meanRadiance(int x, int y, int width) {
    glm::dvec3 sum(0);
    for (int i = 0; i < kSamples * kSamples; ++i) {
        const double column = x + (i % kSamples + 0.5) / kSamples, row = y + (i / kSamples + 0.5) / kSamples;
        const double azimuth = (column / width - 0.5) * 2 * kPi, polar = row / width * 2 * kPi;
        const double ring = std::sin(polar);
        sum += skyRadiance({ring * std::sin(azimuth), std::cos(polar), -ring * std::cos(azimuth)});
    }
    return sum / double(kSamples * kSamples);
}

} // namespace

franken::Result<void> writeSky(const std::filesystem::path& path, int width) {
    const int height = width / 2;
    std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " +
                        std::to_string(2 * height) + "\n";
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < 2 * height; ++x) {
            const auto texel = toRgbe(meanRadiance(x, y, 2 * height));
            bytes.append(reinterpret_cast<const char*>(texel.data()), texel.size());
        }
    return franken::writeFile(path, bytes);
}

} // namespace make_model
