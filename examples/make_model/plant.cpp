// SPDX-License-Identifier: MIT
#include "plant.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "numbers.h"
#include "sheet.h"

namespace make_model {
namespace {

constexpr double kTau = 2.0 * std::numbers::pi;
constexpr glm::dvec3 kUp(0.0, 1.0, 0.0);

// Where the back of the head sits on the stem, and how far it looks up at noon, in turns.
constexpr glm::dvec3 kBack(0.0, 1.12, 0.03);
constexpr double kLooksUp = 0.06;

// The stem's curve: straight up from the ground, and forward into the back of the head.
glm::dvec3 stemAt(double t) {
    constexpr std::array<glm::dvec3, 4> kPoints{
        {{0.0, 0.0, 0.0}, {0.05, 0.42, 0.03}, {-0.05, 0.88, -0.14}, kBack}};
    const double s = 1.0 - t;
    return s * s * s * kPoints[0] + 3.0 * s * s * t * kPoints[1] + 3.0 * s * t * t * kPoints[2] +
           t * t * t * kPoints[3];
}

glm::dvec3 alongStem(double t) {
    constexpr double kStep = 1.0 / 1024.0;
    return glm::normalize(stemAt(t + kStep) - stemAt(t - kStep));
}

// Where the joints of the stem, the neck and the head are on it.
constexpr std::array<double, kHeadJoint + 1> kJointsOnStem{0.0, 0.16, 0.32, 0.48, 0.63, 0.77, 0.89, 1.0};

// A joint holds the stem half way to its neighbours, and shares what is between these points.
Held heldByStem(double t, glm::dvec3 colour) {
    const auto middle = [](int joint) {
        const auto at = static_cast<std::size_t>(joint);
        return 0.5 * (kJointsOnStem[at] + (at < kHeadJoint ? kJointsOnStem[at + 1] : 1.1));
    };
    int joint = 0;
    while (joint + 1 < kHeadJoint && t > middle(joint + 1))
        ++joint;
    const double share = std::clamp((t - middle(joint)) / (middle(joint + 1) - middle(joint)), 0.0, 1.0);
    return heldBy(joint, joint + 1, share, colour);
}

/// An arc that begins at `first` turns above the horizon and ends `bend` turns above that, unit of length:
/// how far out and up it is there.
struct Arc {
    double first, bend;

    double angle(double s) const { return first + bend * s; }
    glm::dvec2 at(double s) const {
        return glm::dvec2(sinTurns(angle(s)) - sinTurns(first), cosTurns(first) - cosTurns(angle(s))) /
               (kTau * bend);
    }
};

struct Leaf {
    double onStem;  ///< Where it grows.
    double azimuth; ///< Turns from +Z to +X.
    double length;  ///< Metres.
};

constexpr std::array<Leaf, kLeaves> kPlantLeaves{
    {{0.22, 0.20, 0.46}, {0.36, 0.78, 0.46}, {0.50, 0.30, 0.40}, {0.62, 0.68, 0.34}}};
constexpr Arc kLeafArc{0.13, -0.23};

glm::dvec3 outwardOf(const Leaf& leaf) { return {sinTurns(leaf.azimuth), 0.0, cosTurns(leaf.azimuth)}; }

glm::dvec3 onLeaf(const Leaf& leaf, double s) {
    const glm::dvec2 arc = leaf.length * kLeafArc.at(s);
    return stemAt(leaf.onStem) + arc.x * outwardOf(leaf) + arc.y * kUp;
}

// A stalk, and a blade that is broadest where it begins, folded along its rib.
glm::dvec3 leafAt(const Leaf& leaf, double u, double v) {
    const double side = 2.0 * u - 1.0;
    const double blade = std::clamp((v - 0.24) / 0.76, 0.0, 1.0);
    const double width =
        leaf.length * (0.026 * (1.0 - v) + 0.36 * ramp(0.0, 0.34, blade) * (1.0 - blade * blade));
    const glm::dvec3 outward = outwardOf(leaf);
    const glm::dvec3 across(outward.z, 0.0, -outward.x);
    const double angle = kLeafArc.angle(v);
    const glm::dvec3 front = cosTurns(angle) * kUp - sinTurns(angle) * outward;
    const double wave = 0.10 * sinTurns(2.5 * v) * side * side;
    const double fold = 0.38 * std::sqrt(side * side + 0.01);
    return onLeaf(leaf, v) + width * (side * across + (fold + wave) * front);
}

void growLeaf(Mesh& mesh, int number) {
    const Leaf& leaf = kPlantLeaves[static_cast<std::size_t>(number)];
    const int joint = kFirstLeafJoint + 2 * number;
    appendSheet(
        mesh, [&leaf](double u, double v) { return leafAt(leaf, u, v); }, 9, 4,
        [joint](double u, double v) {
            const double rib = std::abs(2.0 * u - 1.0);
            const glm::dvec3 vein(0.24, 0.40, 0.10), blade(0.075, 0.21, 0.035), tip(0.13, 0.30, 0.05);
            const glm::dvec3 colour = glm::mix(vein, glm::mix(blade, tip, v * v), ramp(-0.3, 0.7, rib));
            return heldBy(joint, joint + 1, ramp(0.3, 0.7, v), colour);
        });
}

void growStem(Mesh& mesh) {
    const auto shape = [](double u, double v) {
        const double t = 1.0 - v;
        const glm::dvec3 along = alongStem(t);
        const glm::dvec3 across = glm::normalize(glm::dvec3(1.0, 0.0, 0.0) - along.x * along);
        const double radius = 0.028 - 0.009 * t + 0.008 * ramp(0.93, 1.0, t);
        return stemAt(t) + radius * (sinTurns(u) * across + cosTurns(u) * glm::cross(across, along));
    };
    appendSheet(mesh, shape, 18, 8, [](double, double v) {
        return heldByStem(1.0 - v, glm::mix(glm::dvec3(0.20, 0.36, 0.08), glm::dvec3(0.12, 0.24, 0.05), v));
    });
}

void growBackOfTheHead(Mesh& mesh) {
    const auto shape = [](double u, double v) {
        const double radius = kDiscRadius * 1.06 * (1.0 - v * v) + 0.022 * v;
        return inHead({radius * cosTurns(u), radius * sinTurns(u), -kHeadDepth * v - 0.005});
    };
    appendSheet(mesh, shape, 4, 14, [](double, double v) {
        return heldBy(kHeadJoint, glm::mix(glm::dvec3(0.10, 0.22, 0.04), glm::dvec3(0.20, 0.36, 0.08), v));
    });
}

} // namespace

glm::dvec3 inHead(glm::dvec3 local) {
    const double up = sinTurns(kLooksUp), forward = cosTurns(kLooksUp);
    const glm::dvec3 top(0.0, forward, -up), axis(0.0, up, forward);
    return kBack + local.x * glm::dvec3(1.0, 0.0, 0.0) + local.y * top + (local.z + kHeadDepth) * axis;
}

glm::dvec3 acrossLeaf(int leaf) {
    const glm::dvec3 outward = outwardOf(kPlantLeaves[static_cast<std::size_t>(leaf)]);
    return {outward.z, 0.0, -outward.x};
}

std::vector<PlantJoint> plantJoints() {
    std::vector<PlantJoint> joints;
    constexpr std::array<const char*, kHeadJoint + 1> kNames{"stem 1", "stem 2", "stem 3", "stem 4",
                                                             "stem 5", "stem 6", "neck",   "head"};
    for (std::size_t j = 0; j < kNames.size(); ++j)
        joints.push_back({kNames[j], static_cast<int>(j) - 1, stemAt(kJointsOnStem[j])});
    for (const Leaf& leaf : kPlantLeaves) {
        const auto above = std::upper_bound(kJointsOnStem.begin(), kJointsOnStem.end(), leaf.onStem);
        joints.push_back({"leaf", static_cast<int>(above - kJointsOnStem.begin()) - 1, onLeaf(leaf, 0.0)});
        joints.push_back({"leaf tip", static_cast<int>(joints.size()) - 1, onLeaf(leaf, 0.5)});
    }
    return joints;
}

Mesh growGreens() {
    Mesh mesh;
    growStem(mesh);
    for (int leaf = 0; leaf < kLeaves; ++leaf)
        growLeaf(mesh, leaf);
    growBackOfTheHead(mesh);
    return mesh;
}

} // namespace make_model
