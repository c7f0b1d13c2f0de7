// SPDX-License-Identifier: MIT
#pragma once

#include "franken/scene.h"

#include <glm/ext/matrix_double4x4.hpp>

#include <array>

namespace franken {

/// A box along the axes of the world.
struct Bounds {
    glm::dvec3 center{0.0};
    glm::dvec3 extent{0.0}; ///< Half its edges, rounding included.
};

/// The box around `box` as `world`, which is affine, places it. All of space for an empty one.
Bounds boundsOf(const Box& box, const glm::dmat4& world);

/// What a camera sees: the space inside six planes, which are sums of the rows of the matrix (Gribb and
/// Hartmann, "Fast Extraction of Viewing Frustum Planes from the World-View-Projection Matrix", 2001).
class Frustum {
public:
    explicit Frustum(const glm::dmat4& viewProjection);

    /// False only for a box that lies wholly outside one of the planes; a few that lie outside across an edge
    /// of the view are let through.
    bool mayShow(const Bounds& bounds) const;

private:
    static constexpr std::size_t kPlanes = 6;
    /// x, y, z and w of the planes, each in an array of its own for the compiler's vectors: a point is inside
    /// where x px + y py + z pz + w >= 0.
    std::array<std::array<double, kPlanes>, 4> m_planes;
};

} // namespace franken
