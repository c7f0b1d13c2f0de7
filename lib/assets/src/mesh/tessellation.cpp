// SPDX-License-Identifier: MIT
#include "franken/tessellation.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace franken {
namespace {

constexpr double kShareAbove = 0.01;

float turnOf(const glm::vec3 (&normals)[3]) {
    const float cosine = std::min({glm::dot(normals[0], normals[1]), glm::dot(normals[1], normals[2]),
                                   glm::dot(normals[2], normals[0])});
    return std::acos(std::clamp(cosine, -1.0f, 1.0f));
}

} // namespace

float normalTurn(const Primitive& primitive) {
    std::vector<std::pair<float, double>> turns; // With the triangle's area.
    double total = 0;
    for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
        glm::vec3 corners[3], normals[3];
        for (std::size_t corner = 0; corner < 3; ++corner) {
            corners[corner] = primitive.positions[primitive.indices[i + corner]];
            normals[corner] = primitive.normals[primitive.indices[i + corner]];
        }
        const double area = 0.5 * glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
        turns.emplace_back(turnOf(normals), area);
        total += area;
    }
    std::sort(turns.begin(), turns.end(), std::greater<>());
    double above = 0;
    for (const auto& [turn, area] : turns)
        if (above += area; above > kShareAbove * total)
            return turn;
    return 0;
}

} // namespace franken
