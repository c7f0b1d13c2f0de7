// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include <glm/ext/matrix_double4x4.hpp>
#include <glm/ext/vector_double3.hpp>

#include "franken/api.h"

namespace FRANKEN_API franken {

/// An axis-aligned box; empty (min > max) until something is added.
struct Box {
    /// The corners; at first it is empty.
    glm::dvec3 min{std::numeric_limits<double>::infinity()};
    glm::dvec3 max{-std::numeric_limits<double>::infinity()};

    /// Nothing was added.
    bool empty() const { return min.x > max.x; }
    void add(const glm::dvec3& point); ///< Grows, where it has to, until the point is in it.
    /// Adds the eight corners of `box` as `world` places them; does nothing for an empty one.
    void add(const Box& box, const glm::dmat4& world);
};

} // namespace franken
