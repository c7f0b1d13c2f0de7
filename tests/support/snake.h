// SPDX-License-Identifier: MIT
#pragma once

#include "franken/pose.h"

#include <iosfwd>

namespace franken::test {

/// A long ball on a chain of joints.
struct Snake {
    int influences;
    int joints;
    bool target = false;
    bool mirrored = false; ///< By the scale of every third joint.
    int rings = 24;        ///< Of vertices around it.
};

std::ostream& operator<<(std::ostream& out, const Snake& snake);

/// It, with a normal map, and a sun.
Scene sceneOf(const Snake& snake);

/// All joints turned; a target's weight is `amount`.
Pose bent(const Scene& scene, const Snake& snake, double amount);

} // namespace franken::test
