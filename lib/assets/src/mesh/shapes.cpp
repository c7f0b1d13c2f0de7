// SPDX-License-Identifier: MIT
#include "franken/complete.h"

#include "mesh/vertices.h"

#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace franken {
namespace {

/// A face round `out`, with the texture's u along `right` and its v against `up`; all are unit, and scaled by
/// half the size of the shape.
void addFace(Primitive& primitive, const glm::vec3& out, const glm::vec3& right, const glm::vec3& up,
             const glm::vec3& half) {
    const auto first = static_cast<std::uint32_t>(primitive.positions.size());
    for (const auto& [x, y] : {std::pair(-1.0f, -1.0f), {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}}) {
        primitive.positions.push_back((out + x * right + y * up) * half);
        primitive.normals.push_back(out);
        primitive.tangents.emplace_back(right, 1);
        primitive.uv[0].emplace_back(0.5f + 0.5f * x, 0.5f - 0.5f * y);
    }
    for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u})
        primitive.indices.push_back(first + corner);
}

Primitive bounded(Primitive primitive) {
    primitive.bounds = boundsOf(primitive.positions);
    return primitive;
}

constexpr glm::vec3 kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);

void addSphereVertex(Primitive& primitive, float radius, float u, float v) {
    // The seam closes, and the south pole is one point, which the sines of a rounded pi would not make them.
    const float longitude = u == 1 ? 0 : glm::two_pi<float>() * u, polar = glm::pi<float>() * v;
    const float wide = v == 1 ? 0 : std::sin(polar);
    const glm::vec3 normal(wide * std::sin(longitude), std::cos(polar), wide * std::cos(longitude));
    primitive.positions.push_back(radius * normal);
    primitive.normals.push_back(normal);
    primitive.tangents.emplace_back(std::cos(longitude), 0, -std::sin(longitude), 1);
    primitive.uv[0].emplace_back(u, v);
}

} // namespace

Primitive plane(const glm::vec2& size) {
    Primitive primitive;
    addFace(primitive, kZ, kX, kY, 0.5f * glm::vec3(glm::abs(size), 0));
    return bounded(std::move(primitive));
}

Primitive box(const glm::vec3& size) {
    Primitive primitive;
    const glm::vec3 half = 0.5f * glm::abs(size);
    addFace(primitive, kZ, kX, kY, half);
    addFace(primitive, kX, -kZ, kY, half);
    addFace(primitive, -kZ, -kX, kY, half);
    addFace(primitive, -kX, kZ, kY, half);
    addFace(primitive, kY, kX, -kZ, half);
    addFace(primitive, -kY, kX, kZ, half);
    return bounded(std::move(primitive));
}

Primitive sphere(float radius, int rings) {
    constexpr int kFewest = 2, kMost = 1024;
    rings = std::clamp(rings, kFewest, kMost);
    const int columns = 2 * rings;
    Primitive primitive;
    for (int row = 0; row <= rings; ++row)
        for (int column = 0; column <= columns; ++column)
            addSphereVertex(primitive, std::abs(radius),
                            static_cast<float>(column) / static_cast<float>(columns),
                            static_cast<float>(row) / static_cast<float>(rings));
    const auto index = [&](int row, int column) {
        return static_cast<std::uint32_t>(row * (columns + 1) + column);
    };
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        primitive.indices.insert(primitive.indices.end(), {a, b, c});
    };
    for (int row = 0; row < rings; ++row)
        for (int column = 0; column < columns; ++column) { // At the poles, a quad is a triangle.
            if (row + 1 < rings)
                add(index(row, column), index(row + 1, column), index(row + 1, column + 1));
            if (row > 0)
                add(index(row, column), index(row + 1, column + 1), index(row, column + 1));
        }
    return bounded(std::move(primitive));
}

} // namespace franken
