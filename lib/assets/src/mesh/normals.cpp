// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include <glm/geometric.hpp>

#include "franken/tangents.h"
#include "mesh/vertices.h"

namespace franken {
namespace {

/// For each vertex the first one at its position.
std::vector<std::size_t> firstAtPosition(const std::vector<glm::vec3>& positions) {
    std::map<std::tuple<float, float, float>, std::size_t> known;
    std::vector<std::size_t> first;
    first.reserve(positions.size());
    for (const glm::vec3& position : positions)
        first.push_back(known.try_emplace({position.x, position.y, position.z}, first.size()).first->second);
    return first;
}

glm::dvec3 unitOrNone(const glm::dvec3& vector) {
    const double length = glm::length(vector); // in double: no triangle of floats under- or overflows
    return length > 0.0 ? vector / length : glm::dvec3(0.0);
}

glm::vec3 unitOrZ(const glm::dvec3& vector) {
    const glm::dvec3 unit = unitOrNone(vector);
    return unit == glm::dvec3(0.0) ? glm::vec3(0.0f, 0.0f, 1.0f) : glm::vec3(unit);
}

} // namespace

void computeFlatNormals(Primitive& primitive) {
    primitive.normals.clear();
    primitive.tangents.clear();
    gather(primitive, primitive.indices);
    std::iota(primitive.indices.begin(), primitive.indices.end(), 0u);

    primitive.normals.assign(primitive.positions.size(), glm::vec3(0.0f, 0.0f, 1.0f));
    for (std::size_t i = 0; i + 2 < primitive.positions.size(); i += 3) {
        const glm::dvec3 a(primitive.positions[i]), b(primitive.positions[i + 1]),
            c(primitive.positions[i + 2]);
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        std::fill_n(primitive.normals.begin() + static_cast<std::ptrdiff_t>(i), 3, unitOrZ(normal));
    }
}

void computeSmoothNormals(Primitive& primitive) {
    const std::vector<std::size_t> first = firstAtPosition(primitive.positions);
    std::vector<glm::dvec3> sums(first.size(), glm::dvec3(0.0));
    for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
        std::array<std::size_t, 3> corner;
        std::array<glm::dvec3, 3> edge; // From each corner to the next.
        for (std::size_t n = 0; n < 3; ++n)
            corner[n] = first[primitive.indices[i + n]];
        for (std::size_t n = 0; n < 3; ++n)
            edge[n] = unitOrNone(glm::dvec3(primitive.positions[corner[(n + 1) % 3]]) -
                                 glm::dvec3(primitive.positions[corner[n]]));
        for (std::size_t n = 0; n < 3; ++n) {
            const glm::dvec3 back = -edge[(n + 2) % 3], cross = glm::cross(edge[n], back);
            const double angle = std::atan2(glm::length(cross), glm::dot(edge[n], back));
            sums[corner[n]] += angle * unitOrNone(cross);
        }
    }
    primitive.tangents.clear();
    primitive.normals.clear();
    for (const std::size_t vertex : first)
        primitive.normals.push_back(unitOrZ(sums[vertex]));
}

} // namespace franken
