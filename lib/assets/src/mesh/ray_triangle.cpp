// SPDX-License-Identifier: MIT
#include "mesh/ray_triangle.h"

#include <glm/common.hpp>

#include <utility>

namespace franken {
namespace {

int longestAxis(const glm::dvec3& direction) {
    const glm::dvec3 length = glm::abs(direction);
    return length.x >= length.y && length.x >= length.z ? 0 : length.y >= length.z ? 1 : 2;
}

} // namespace

RayShear::RayShear(const glm::dvec3& origin, const glm::dvec3& direction)
    : m_origin(origin), m_z(longestAxis(direction)) {
    m_x = (m_z + 1) % 3;
    m_y = (m_x + 1) % 3;
    if (direction[m_z] < 0)
        std::swap(m_x, m_y); // So that front faces stay front faces.
    m_shear = glm::dvec3(direction[m_x], direction[m_y], 1.0) / direction[m_z];
}

std::optional<RayShear::Crossing> RayShear::cross(const Corners& corners) const {
    std::array<glm::dvec3, 3> p; // With the ray along z.
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 corner = glm::dvec3(corners[i]) - m_origin;
        p[i] = {corner[m_x] - m_shear.x * corner[m_z], corner[m_y] - m_shear.y * corner[m_z],
                m_shear.z * corner[m_z]};
    }
    const glm::dvec3 edges(p[2].x * p[1].y - p[2].y * p[1].x, p[0].x * p[2].y - p[0].y * p[2].x,
                           p[1].x * p[0].y - p[1].y * p[0].x);
    const bool below = edges.x < 0 || edges.y < 0 || edges.z < 0;
    const bool above = edges.x > 0 || edges.y > 0 || edges.z > 0;
    const double sum = edges.x + edges.y + edges.z;
    if ((below && above) || sum == 0)
        return std::nullopt;
    const glm::dvec3 shares = edges / sum;
    return Crossing{shares.x * p[0].z + shares.y * p[1].z + shares.z * p[2].z, shares, sum > 0};
}

} // namespace franken
