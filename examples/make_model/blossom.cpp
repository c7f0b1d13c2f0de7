// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>

#include "lathe.h"
#include "numbers.h"
#include "plant.h"
#include "sheet.h"

namespace make_model {
namespace {

constexpr double kTau = 2.0 * std::numbers::pi;
constexpr double kGoldenTurns = 0.38196601125; // Of a circle: 2 - the golden ratio, 1.618.

double bulge(double r) { return 0.034 * (1.0 - r * r / (kDiscRadius * kDiscRadius)); }

// From the middle, which is not ripe, to the rim, where small blossoms stand. Linear.
glm::dvec3 seedColour(double r) {
    const double out = r / kDiscRadius;
    const glm::dvec3 inner =
        glm::mix(glm::dvec3(0.16, 0.15, 0.03), glm::dvec3(0.055, 0.022, 0.008), ramp(0.1, 0.45, out));
    return glm::mix(inner, glm::dvec3(0.42, 0.17, 0.015), ramp(0.66, 0.9, out));
}

void growDisc(Mesh& mesh) {
    appendSheet(
        mesh,
        [](double u, double v) {
            const double r = kDiscRadius * v;
            return inHead({r * cosTurns(u), r * sinTurns(u), bulge(r)});
        },
        4, 16, [](double, double v) { return heldBy(kHeadJoint, 0.45 * seedColour(kDiscRadius * v)); });
}

// A pyramid of three sides that points away from the disc, where sunflowers have it: Vogel, "A better way to
// construct the sunflower head", 1979.
void growSeed(Mesh& mesh, double r, double turns) {
    const double out = r / kDiscRadius;
    const double size = 0.0115, height = 0.010 + 0.010 * ramp(0.6, 0.95, out);
    const glm::dvec3 outward(cosTurns(turns), sinTurns(turns), 0.0), along(-outward.y, outward.x, 0.0);
    const glm::dvec3 lean = glm::normalize(glm::dvec3(0.0, 0.0, 1.0) + 0.5 * out * outward);
    const glm::dvec3 middle = r * outward + glm::dvec3(0.0, 0.0, bulge(r));
    const glm::dvec3 origin = inHead(glm::dvec3(0.0));
    const auto first = static_cast<std::uint16_t>(mesh.positions.size());
    const auto append = [&](glm::dvec3 position, glm::dvec3 normal, glm::dvec3 colour) {
        const Held held = heldBy(kHeadJoint, colour);
        mesh.positions.push_back(snap(inHead(position)));
        mesh.normals.emplace_back(glm::normalize(inHead(normal) - origin));
        mesh.colours.push_back(held.colour);
        mesh.joints.push_back(held.joints);
        mesh.weights.push_back(held.weights);
    };
    for (int corner = 0; corner < 3; ++corner) {
        const glm::dvec3 side = cosTurns(corner / 3.0) * outward + sinTurns(corner / 3.0) * along;
        append(middle + size * side, side + 0.35 * lean, 0.55 * seedColour(r));
    }
    append(middle + height * lean, lean, glm::min(1.7 * seedColour(r), glm::dvec3(1.0)));
    for (std::uint16_t corner = 0; corner < 3; ++corner)
        for (const int index : {first + corner, first + (corner + 1) % 3, first + 3})
            mesh.indices.push_back(static_cast<std::uint16_t>(index));
}

/// How wide the blossom is open.
enum Stage { kOpen, kHalf, kClosed, kStages };

struct Petal {
    double azimuth; ///< Turns about the head's axis.
    double radius;  ///< Where it begins, metres.
    double behind;  ///< The disc's rim, metres.
    double length;
    double width; ///< Half of it.
    /// By stage: the angle above the disc's plane where it begins, and what its tip adds to that; turns.
    double rises[kStages], bends[kStages];
    bool isSepal;
};

glm::dvec3 petalAt(const Petal& petal, Stage stage, double u, double v) {
    const double first = petal.rises[stage], bend = petal.bends[stage];
    const double angle = first + bend * v, side = 2.0 * u - 1.0;
    const glm::dvec2 arc = petal.length / (kTau * bend) *
                           glm::dvec2(sinTurns(angle) - sinTurns(first), cosTurns(first) - cosTurns(angle));
    const glm::dvec3 outward(cosTurns(petal.azimuth), sinTurns(petal.azimuth), 0.0);
    const glm::dvec3 across(-outward.y, outward.x, 0.0), axis(0.0, 0.0, 1.0);
    const glm::dvec3 front = cosTurns(angle) * axis - sinTurns(angle) * outward;
    const double narrow = stage == kClosed ? 0.8 : 1.0;
    const double from = 0.12 + 0.88 * v; // The narrowest end is under the disc.
    const double width =
        narrow * petal.width * std::sqrt(std::max(4.0 * from * (1.0 - from), 0.0)) * (1.15 - 0.3 * v);
    return inHead((petal.radius + arc.x) * outward + (arc.y - petal.behind) * axis +
                  width * (side * across + 0.3 * side * side * front));
}

Petal petalOf(int number, int count, bool inner) {
    const auto seed = inner ? 101u : 77u;
    const double jitter = hash(number, 1, seed) - 0.5, other = hash(number, 2, seed) - 0.5;
    const double rise = (inner ? 0.045 : -0.012) + 0.03 * jitter;
    return {.azimuth = (number + (inner ? 0.5 : 0.0) + 0.3 * other) / count,
            .radius = inner ? 0.128 : 0.138,
            .behind = inner ? 0.000 : 0.010,
            .length = (inner ? 0.205 : 0.235) * (1.0 + 0.14 * jitter),
            .width = 0.041 * (1.0 + 0.15 * other),
            .rises = {rise, 0.14 + 0.02 * jitter, 0.268 + 0.012 * jitter},
            .bends = {-0.055 + 0.03 * other, -0.02, 0.055},
            .isSepal = false};
}

Petal sepalOf(int number, int count) {
    return {.azimuth = (number + 0.25) / count,
            .radius = 0.145,
            .behind = 0.022,
            .length = 0.15 + 0.02 * hash(number, 3, 55u),
            .width = 0.036,
            .rises = {-0.055, 0.10, 0.242},
            .bends = {-0.05, -0.01, 0.045},
            .isSepal = true};
}

// Gold, darker along the middle and red where it begins. Linear.
glm::dvec3 petalColour(const Petal& petal, double u, double v) {
    const double edge = ramp(0.0, 1.0, std::abs(2.0 * u - 1.0));
    if (petal.isSepal)
        return glm::mix(glm::dvec3(0.09, 0.20, 0.035), glm::dvec3(0.17, 0.33, 0.07), v) * (0.8 + 0.2 * edge);
    const glm::dvec3 gold = glm::mix(glm::dvec3(0.90, 0.42, 0.012), glm::dvec3(0.97, 0.60, 0.035), v);
    return glm::mix(glm::dvec3(0.40, 0.10, 0.008), gold, ramp(-0.05, 0.42, v)) * (0.82 + 0.18 * edge);
}

std::vector<Petal> petals() {
    constexpr int kInRing = 15, kSepals = 11;
    std::vector<Petal> all;
    for (int number = 0; number < kSepals; ++number)
        all.push_back(sepalOf(number, kSepals));
    for (const bool inner : {false, true})
        for (int number = 0; number < kInRing; ++number)
            all.push_back(petalOf(number, kInRing, inner));
    return all;
}

} // namespace

Mesh growSeeds() {
    constexpr int kSeeds = 100;
    Mesh mesh;
    growDisc(mesh);
    for (int number = 0; number < kSeeds; ++number)
        growSeed(mesh, 0.97 * kDiscRadius * std::sqrt((number + 0.5) / kSeeds), number * kGoldenTurns);
    return mesh;
}

Mesh growBlossom() {
    constexpr int kColumns = 2;
    Mesh mesh;
    mesh.targets = {{.name = "half closed"}, {.name = "closed"}};
    for (const Petal& petal : petals()) {
        const int rows = petal.isSepal ? 3 : 5;
        const auto shape = [&petal](Stage stage) {
            return [&petal, stage](double u, double v) { return petalAt(petal, stage, u, v); };
        };
        appendSheet(mesh, shape(kOpen), rows, kColumns,
                    [&petal](double u, double v) { return heldBy(kHeadJoint, petalColour(petal, u, v)); });
        appendChange(mesh.targets[0], shape(kOpen), shape(kHalf), rows, kColumns);
        appendChange(mesh.targets[1], shape(kOpen), shape(kClosed), rows, kColumns);
    }
    return mesh;
}

} // namespace make_model
