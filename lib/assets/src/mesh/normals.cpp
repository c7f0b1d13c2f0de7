// SPDX-License-Identifier: MIT
#include <numeric>

#include <glm/geometric.hpp>

#include "franken/tangents.h"
#include "mesh/vertices.h"

namespace franken {
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
        const double length = glm::length(normal); // in double: no triangle of floats under- or overflows
        if (length > 0.0)
            for (std::size_t corner = i; corner < i + 3; ++corner)
                primitive.normals[corner] = glm::vec3(normal / length);
    }
}

} // namespace franken
