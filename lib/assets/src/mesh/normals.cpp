// SPDX-License-Identifier: MIT
#include <numeric>

#include <glm/geometric.hpp>

#include "franken/tangents.h"

namespace franken {
namespace {

template<typename T>
void unshare(std::vector<T>& attribute, const std::vector<std::uint32_t>& indices) {
    if (attribute.empty())
        return;
    std::vector<T> corners;
    corners.reserve(indices.size());
    for (const std::uint32_t index : indices)
        corners.push_back(attribute[index]);
    attribute = std::move(corners);
}

} // namespace

void computeFlatNormals(Primitive& primitive) {
    unshare(primitive.positions, primitive.indices);
    unshare(primitive.uv[0], primitive.indices);
    unshare(primitive.uv[1], primitive.indices);
    unshare(primitive.colors, primitive.indices);
    primitive.tangents.clear();
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
