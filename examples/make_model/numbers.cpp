// SPDX-License-Identifier: MIT
#include "numbers.h"

#include <cmath>
#include <cstdint>
#include <numbers>

namespace make_model {

double sinTurns(double turns) {
    double x = turns - std::floor(turns + 0.5);
    if (x > 0.25)
        x = 0.5 - x;
    else if (x < -0.25)
        x = -0.5 - x;

    const double radians = 2.0 * std::numbers::pi * x;
    const double square = radians * radians;
    double series = 1.0;
    for (int power = 18; power >= 2; power -= 2)
        series = 1.0 - series * square / (power * (power + 1.0));
    return radians * series;
}

double cosTurns(double turns) { return sinTurns(turns + 0.25); }

double hash(int x, int y, unsigned seed) {
    auto bits =
        static_cast<std::uint32_t>(x) * 0x9E3779B1u + static_cast<std::uint32_t>(y) * 0x85EBCA77u + seed;
    bits = (bits ^ (bits >> 16)) * 0x85EBCA6Bu;
    bits = (bits ^ (bits >> 13)) * 0xC2B2AE35u;
    return (bits ^ (bits >> 16)) / 4294967296.0;
}

double noise(glm::dvec2 point, int period, unsigned seed) {
    const glm::dvec2 cell(std::floor(point.x), std::floor(point.y));
    const glm::dvec2 inCell = point - cell;
    const int y = static_cast<int>(cell.y);
    const int left = ((static_cast<int>(cell.x) % period) + period) % period;
    const int right = (left + 1) % period;

    const double across = ramp(0.0, 1.0, inCell.x);
    const double above = glm::mix(hash(left, y, seed), hash(right, y, seed), across);
    const double below = glm::mix(hash(left, y + 1, seed), hash(right, y + 1, seed), across);
    return glm::mix(above, below, ramp(0.0, 1.0, inCell.y));
}

double cloud(glm::dvec2 point, int period, unsigned seed) {
    double sum = 0.0;
    double weight = 8.0 / 15.0;
    for (unsigned octave = 0; octave < 4; ++octave) {
        sum += weight * noise(point, period, seed + octave);
        point *= 2.0;
        period *= 2;
        weight *= 0.5;
    }
    return sum;
}

double ramp(double low, double high, double x) {
    const double t = glm::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

} // namespace make_model
