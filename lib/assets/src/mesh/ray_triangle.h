// SPDX-License-Identifier: MIT
#pragma once

#include <glm/ext/vector_double3.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <optional>

namespace franken {

/// Of a triangle.
using Corners = std::array<glm::vec3, 3>;

/// A ray as triangles are tested against it. S. Woop, C. Benthin, I. Wald, "Watertight Ray/Triangle
/// Intersection", Journal of Computer Graphics Techniques 2 (1), 2013: a shear makes the ray an axis, and
/// two triangles compute the same number for the edge that they share.
class RayShear {
public:
    RayShear(const glm::dvec3& origin, const glm::dvec3& direction);

    struct Crossing {
        double distance;        ///< In lengths of the direction; negative behind the origin.
        glm::dvec3 barycentric; ///< Shares of the corners.
        bool front;             ///< The corners run counter-clockwise, as seen from the origin.
    };
    /// Nothing where the triangle is missed, has no area, or is seen from its edge.
    std::optional<Crossing> cross(const Corners& corners) const;

private:
    glm::dvec3 m_origin;
    int m_x, m_y, m_z; ///< The axes, the last of them along which the ray is longest.
    glm::dvec3 m_shear;
};

} // namespace franken
