// SPDX-License-Identifier: MIT
#include "ornament.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

#include "numbers.h"

namespace make_model {
namespace {

// Inside both of the discs whose outlines pass through (±halfWidth, 0) and (0, ±halfLength).
double lens(glm::dvec2 point, double halfWidth, double halfLength) {
    const double radius = (halfLength * halfLength + halfWidth * halfWidth) / (2.0 * halfWidth);
    const double offset = radius - halfWidth;
    return glm::length(glm::dvec2(std::abs(point.x) + offset, point.y)) - radius;
}

} // namespace

double disc(glm::dvec2 point, double radius) { return glm::length(point) - radius; }

double leaf(glm::dvec2 point, double halfWidth, double halfLength) {
    return lens(point, halfWidth, halfLength);
}

double arch(glm::dvec2 point, double halfWidth, double rise, double sill) {
    const double sides = point.y > 0.0 ? lens(point, halfWidth, rise) : std::abs(point.x) - halfWidth;
    return std::max(sides, -sill - point.y);
}

double rosette(glm::dvec2 point, double radius) {
    point = glm::abs(point);
    if (point.x > point.y)
        std::swap(point.x, point.y);

    // Now within 45° of straight up; the mirror at 22.5° makes the diagonal petal an upright one.
    const glm::dvec2 mirror(cosTurns(1.0 / 16.0), -sinTurns(1.0 / 16.0));
    const double beyond = glm::dot(point, mirror);
    if (beyond > 0.0)
        point -= 2.0 * beyond * mirror;
    return leaf(point - glm::dvec2(0.0, 0.55 * radius), 0.17 * radius, 0.45 * radius);
}

double wave(glm::dvec2 point, double height, double length) {
    const double turns = point.x / length;
    const double slope = 2.0 * std::numbers::pi * height / length * cosTurns(turns);
    return std::abs(point.y - height * sinTurns(turns)) / std::sqrt(1.0 + slope * slope);
}

glm::dvec2 repeat(glm::dvec2 point, double pitch) {
    return {point.x - (std::floor(point.x / pitch) + 0.5) * pitch, point.y};
}

double cover(double distance, double texel) { return std::clamp(0.5 - distance / texel, 0.0, 1.0); }

double stroke(double distance, double width, double texel) {
    return cover(std::abs(distance) - 0.5 * width, texel);
}

double swell(double distance, double depth) { return ramp(0.0, depth, -distance); }

double dome(glm::dvec2 point, double radius) {
    return std::sqrt(std::max(1.0 - glm::dot(point, point) / (radius * radius), 0.0));
}

bool greekKey(glm::dvec2 point) {
    constexpr std::array<std::string_view, 7> kUnit{
        "#######.", //
        "#.....#.", //
        "#.###.#.", //
        "#.#...#.", //
        "#.#####.", //
        "#.......", //
        "########",
    };
    if (point.y < 0.0 || point.y >= 1.0)
        return false;
    const double x = point.x - std::floor(point.x);
    return kUnit[static_cast<std::size_t>(point.y * 7.0)][static_cast<std::size_t>(x * 8.0)] == '#';
}

double dents(glm::dvec2 point, int period, unsigned seed) {
    const int column = static_cast<int>(std::floor(point.x));
    const int row = static_cast<int>(std::floor(point.y));
    double nearest = 8.0;
    for (int y = row - 1; y <= row + 1; ++y)
        for (int x = column - 1; x <= column + 1; ++x) {
            const int wrapped = (x % period + period) % period;
            const glm::dvec2 centre(x + hash(wrapped, y, seed), y + hash(wrapped, y, seed + 1));
            const glm::dvec2 away = point - centre;
            nearest = std::min(nearest, glm::dot(away, away));
        }
    return nearest;
}

} // namespace make_model
