// SPDX-License-Identifier: MIT
#include "frustum.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>
#include <limits>

namespace franken {

Bounds boundsOf(const Box& box, const glm::dmat4& world) {
    if (box.empty())
        return {glm::dvec3(0), glm::dvec3(std::numeric_limits<double>::infinity())};
    const glm::dvec3 low(box.min), high(box.max);
    const glm::dvec3 half = 0.5 * (high - low);
    return {glm::dvec3(world * glm::dvec4(0.5 * (low + high), 1)),
            glm::abs(glm::dvec3(world[0])) * half.x + glm::abs(glm::dvec3(world[1])) * half.y +
                glm::abs(glm::dvec3(world[2])) * half.z};
}

Frustum::Frustum(const glm::dmat4& viewProjection) {
    const glm::dmat4 rows = glm::transpose(viewProjection);
    for (int axis = 0; axis < 3; ++axis) {
        m_planes[static_cast<std::size_t>(2 * axis)] = rows[3] + rows[axis];
        m_planes[static_cast<std::size_t>(2 * axis + 1)] = rows[3] - rows[axis];
    }
}

bool Frustum::mayShow(const Bounds& bounds) const {
    // The GPU works in float: what its rounding could bring back into view is kept.
    constexpr double kRounding = 1e-5;
    for (const glm::dvec4& plane : m_planes) {
        const glm::dvec3 normal(plane);
        const double reach = glm::dot(glm::abs(normal), bounds.extent);
        const double distance = glm::dot(normal, bounds.center) + plane.w;
        if (distance + reach < -kRounding * (std::abs(plane.w) + reach))
            return false;
    }
    return true;
}

} // namespace franken
