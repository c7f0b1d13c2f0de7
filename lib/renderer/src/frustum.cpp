// SPDX-License-Identifier: MIT
#include "frustum.h"

#include <glm/common.hpp>
#include <glm/ext/vector_double3.hpp>
#include <glm/ext/vector_double4.hpp>

#include <cmath>
#include <limits>

namespace franken {

Bounds boundsOf(const Box& box, const glm::dmat4& world) {
    if (box.empty())
        return {glm::dvec3(0), glm::dvec3(std::numeric_limits<double>::infinity())};
    const glm::dvec3 half = 0.5 * (box.max - box.min);
    const glm::dvec3 center(world * glm::dvec4(0.5 * (box.min + box.max), 1));
    const glm::dvec3 extent = glm::abs(glm::dvec3(world[0])) * half.x +
                              glm::abs(glm::dvec3(world[1])) * half.y +
                              glm::abs(glm::dvec3(world[2])) * half.z;
    // The GPU works in float: what its rounding, and ours, could bring back into view is kept.
    constexpr double kRounding = 1e-5, kCenterRounding = 1e-6;
    return {center, extent * (1 + kRounding) + glm::abs(center) * kCenterRounding};
}

Frustum::Frustum(const glm::dmat4& viewProjection) {
    for (int column = 0; column < 4; ++column)
        for (int axis = 0; axis < 3; ++axis) {
            const double row = viewProjection[column][axis], last = viewProjection[column][3];
            auto& planes = m_planes[static_cast<std::size_t>(column)];
            planes[static_cast<std::size_t>(2 * axis)] = last + row;
            planes[static_cast<std::size_t>(2 * axis + 1)] = last - row;
        }
}

bool Frustum::mayShow(const Bounds& bounds) const {
    const auto& [x, y, z, w] = m_planes;
    const glm::dvec3 &center = bounds.center, &extent = bounds.extent;
    bool outside = false;
    for (std::size_t plane = 0; plane < kPlanes; ++plane) {
        const double distance = x[plane] * center.x + y[plane] * center.y + z[plane] * center.z + w[plane];
        const double reach =
            std::abs(x[plane]) * extent.x + std::abs(y[plane]) * extent.y + std::abs(z[plane]) * extent.z;
        outside |= distance < -reach;
    }
    return !outside;
}

} // namespace franken
