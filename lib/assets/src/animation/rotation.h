// SPDX-License-Identifier: MIT
#pragma once

#include <glm/gtc/quaternion.hpp>

namespace franken {

/// Of length 1; a quaternion of length 0 turns nothing.
inline glm::dquat unit(const glm::dquat& rotation) {
    const double length = glm::length(rotation);
    return length > 0.0 ? rotation / length : glm::dquat(1.0, 0.0, 0.0, 0.0);
}

} // namespace franken
