// SPDX-License-Identifier: MIT
#include "plinth.h"

#include <cmath>

#include "numbers.h"
#include "ornament.h"

namespace make_model {
namespace {

enum PlinthPiece : std::size_t { kTop, kEdge, kUpperCove, kDrum, kLowerCove, kStep };

Surface stone(const Spot& spot) {
    const glm::dvec2 place(spot.u * 7.0, spot.v * 6.0);
    const double drift = cloud(place, 7, 41);
    const glm::dvec2 bent = place + 1.6 * glm::dvec2(drift, cloud(place, 7, 51));
    const double vein = 1.0 - ramp(0.0, 0.09, std::abs(2.0 * cloud(bent, 7, 61) - 1.0));
    const double grain = noise({spot.u * 64.0, spot.v * 64.0}, 64, 71);

    const glm::dvec3 ground = glm::mix(glm::dvec3(0.60, 0.54, 0.47), glm::dvec3(0.74, 0.69, 0.61), drift);
    const glm::dvec3 veined = glm::mix(ground, glm::dvec3(0.40, 0.33, 0.29), 0.55 * vein);
    return {.colour = veined * (0.96 + 0.08 * grain), .height = 0.0004 * grain - 0.0008 * vein};
}

// The share of a texel that the key's line covers, from a grid of points within it.
double engraved(const Spot& spot) {
    constexpr int kUnits = 6;
    constexpr int kPoints = 4;
    constexpr double kHeight = 0.102;
    double sum = 0.0;
    for (int row = 0; row < kPoints; ++row)
        for (int column = 0; column < kPoints; ++column) {
            const double x = spot.x() + spot.texel * ((column + 0.5) / kPoints - 0.5);
            const double y = spot.y() + spot.texel * ((row + 0.5) / kPoints - 0.5);
            sum += greekKey({(x / spot.width + 1.0) * kUnits, 0.5 - y / kHeight}) ? 1.0 : 0.0;
        }
    return sum / (kPoints * kPoints);
}

} // namespace

Profile plinthProfile() {
    return Profile({
        {{{{{0.200, 0.000}, {0.300, 0.000}, {0.400, 0.000}, {0.500, 0.000}}}}, 2, {}},
        {{{{{0.500, 0.000}, {0.535, 0.000}, {0.555, -0.018}, {0.555, -0.045}}}}, 4, {}},
        {{{{{0.555, -0.045}, {0.555, -0.075}, {0.510, -0.070}, {0.510, -0.095}}}}, 4, {}},
        {{{{{0.510, -0.095}, {0.510, -0.142}, {0.510, -0.188}, {0.510, -0.235}}}}, 1, {}},
        {{{{{0.510, -0.235}, {0.510, -0.265}, {0.580, -0.255}, {0.580, -0.280}}}}, 4, {}},
        {{{{{0.580, -0.280}, {0.600, -0.280}, {0.600, -0.310}, {0.600, -0.345}}}}, 3, {}},
    });
}

Surface paintPlinth(const Spot& spot) {
    Surface surface = stone(spot);
    if (spot.piece == kTop)
        surface.openness = 0.25 + 0.75 * ramp(0.2, 0.8, spot.t); // The foot's edge is at t = 0.3.
    if (spot.piece == kUpperCove || spot.piece == kLowerCove)
        surface.openness = 1.0 - 1.8 * spot.t * (1.0 - spot.t);
    if (spot.piece == kDrum) {
        Surface paint = surface;
        paint.colour = glm::dvec3(0.07, 0.24, 0.28);
        paint.height -= 0.004;
        surface = blend(surface, paint, engraved(spot));
    }
    return surface;
}

} // namespace make_model
