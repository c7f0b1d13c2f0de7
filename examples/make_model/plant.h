// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model.h"

namespace make_model {

/// The sunflower's parts, as they are at noon, with their joints. It stands on y = 0 and looks up and to +Z.

/// A joint of the plant.
struct PlantJoint {
    const char* name;
    int parent; ///< Index into plantJoints(); -1 for the root.
    glm::dvec3 position;
};

/// The joints of the stem, from the ground up.
constexpr int kStemJoints = 6;
/// The joints behind those of the stem.
constexpr int kNeckJoint = kStemJoints, kHeadJoint = kStemJoints + 1, kFirstLeafJoint = kStemJoints + 2;
/// Each leaf has a joint where it begins and one in its middle, one after the other.
constexpr int kLeaves = 4;

/// From the disc's middle to its rim, and from the back of the head to the disc, metres.
constexpr double kDiscRadius = 0.15, kHeadDepth = 0.075;

/// A point of the head, as seen from the middle of its disc, which looks along +Z with +Y up.
glm::dvec3 inHead(glm::dvec3 local);

/// What a leaf droops about.
glm::dvec3 acrossLeaf(int leaf);

/// Each after its parent. None is turned: from mesh to joint there is only a way.
std::vector<PlantJoint> plantJoints();

/// Stem, leaves, and the back of the head.
Mesh growGreens();

/// The disc with its seeds.
Mesh growSeeds();

/// The petals and sepals, open; its targets make them half closed, and closed.
Mesh growBlossom();

} // namespace make_model
