// SPDX-License-Identifier: MIT
#include "franken/deform.h"

#include "mesh/vertices.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace franken {
namespace {

template<typename Vector>
void addTo(std::vector<Vector>& values, const std::vector<Vector>& differences, float weight) {
    for (std::size_t i = 0; i < differences.size() && i < values.size(); ++i)
        values[i] += weight * differences[i];
}

void addTarget(Vertices& vertices, const Vertices& target, float weight) {
    addTo(vertices.positions, target.positions, weight);
    addTo(vertices.normals, target.normals, weight);
    addTo(vertices.tangents, target.tangents, weight);
    addTo(vertices.uv[0], target.uv[0], weight);
    addTo(vertices.uv[1], target.uv[1], weight);
    addTo(vertices.colors, target.colors, weight);
}

// Lengths whose square a float can hold need no double.
glm::vec3 unit(const glm::vec3& vector, const glm::vec3& otherwise) {
    const float square = glm::dot(vector, vector);
    constexpr float kLeast = 1e-30f, kMost = 1e30f;
    return square > kLeast && square < kMost ? vector / std::sqrt(square) : unitOr(vector, otherwise);
}

/// What a normal turns by: the inverse transpose, up to a positive factor, as cofactors, so that a joint
/// scaled to nothing does no harm.
glm::mat3 normalMatrix(const glm::mat4x3& matrix) {
    const glm::vec3 &x = matrix[0], &y = matrix[1], &z = matrix[2];
    const glm::mat3 result(glm::cross(y, z), glm::cross(z, x), glm::cross(x, y));
    return glm::dot(x, result[0]) < 0.0f ? -result : result;
}

class Skinning {
public:
    Skinning(const Deformation& deformation, const Deforming& pose)
        : m_count(deformation.influencesPerVertex),
          m_influences(deformation.influences.data()),
          m_joints(pose.joints.data()) {}

    glm::mat4x3 matrixOf(std::size_t vertex) const {
        const Influence* const influences = m_influences + vertex * m_count;
        glm::mat4x3 blended = influences[0].weight * m_joints[influences[0].joint];
        for (std::size_t i = 1; i < m_count; ++i) // A test of each weight would take as long again.
            blended += influences[i].weight * m_joints[influences[i].joint];
        return blended;
    }

private:
    std::size_t m_count;
    const Influence* m_influences;
    const glm::mat4x3* m_joints;
};

void applySkin(const Skinning& skin, Vertices& vertices) {
    const bool hasNormals = !vertices.normals.empty(), hasTangents = !vertices.tangents.empty();
    for (std::size_t v = 0; v < vertices.positions.size(); ++v) {
        const glm::mat4x3 matrix = skin.matrixOf(v);
        vertices.positions[v] = matrix * glm::vec4(vertices.positions[v], 1.0f);
        if (hasNormals)
            vertices.normals[v] = normalMatrix(matrix) * vertices.normals[v];
        if (hasTangents)
            vertices.tangents[v] =
                glm::vec4(glm::mat3(matrix) * glm::vec3(vertices.tangents[v]), vertices.tangents[v].w);
    }
}

void normalize(const Vertices& bind, Vertices& vertices) {
    for (std::size_t v = 0; v < vertices.normals.size(); ++v)
        vertices.normals[v] = unit(vertices.normals[v], bind.normals[v]);
    for (std::size_t v = 0; v < vertices.tangents.size(); ++v) {
        const glm::vec4& tangent = vertices.tangents[v];
        vertices.tangents[v] = glm::vec4(unit(glm::vec3(tangent), glm::vec3(bind.tangents[v])), tangent.w);
    }
}

// As glTF 2.0 (3.7.2.1) has it for files without normals. Where a mirrored node has a skin, what winds
// clockwise is front, though joints have moved the vertices to where they stay; without one, its matrix turns
// the normals.
void flatten(Vertices& vertices, bool mirrored) {
    for (std::size_t v = 0; v + 2 < vertices.positions.size(); v += 3) {
        const glm::dvec3 a(vertices.positions[v]), b(vertices.positions[v + 1]), c(vertices.positions[v + 2]);
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        if (const double length = glm::length(normal); length > 0.0)
            std::fill_n(vertices.normals.begin() + static_cast<std::ptrdiff_t>(v), 3,
                        glm::vec3((mirrored ? -1.0 : 1.0) / length * normal));
    }
}

} // namespace

void measure(Deformation& deformation) {
    deformation.box = boundsOf(deformation.bind.positions);
    deformation.targetBoxes.clear();
    for (const Vertices& target : deformation.targets) {
        Box& box = deformation.targetBoxes.emplace_back(boundsOf(target.positions));
        box.add(glm::dvec3(0.0));
    }
    deformation.jointBoxes.clear();
    for (std::size_t i = 0; i < deformation.influences.size(); ++i) {
        const auto& [joint, weight] = deformation.influences[i];
        if (weight == 0.0f)
            continue;
        if (joint >= deformation.jointBoxes.size())
            deformation.jointBoxes.resize(joint + 1);
        deformation.jointBoxes[joint].add(
            glm::dvec3(deformation.bind.positions[i / deformation.influencesPerVertex]));
    }
}

void deform(const Deformation& deformation, const Deforming& pose, Vertices& out) {
    out = deformation.bind;
    for (std::size_t t = 0; t < std::min(pose.weights.size(), deformation.targets.size()); ++t)
        if (pose.weights[t] != 0.0f)
            addTarget(out, deformation.targets[t], pose.weights[t]);
    for (glm::vec4& color : out.colors)
        color = glm::clamp(color, 0.0f, 1.0f); // glTF 2.0, 3.7.2.2.
    const bool isSkinned = !pose.joints.empty() && deformation.influencesPerVertex > 0;
    if (isSkinned)
        applySkin(Skinning(deformation, pose), out);
    if (deformation.flat)
        flatten(out, isSkinned && pose.mirrored);
    normalize(deformation.bind, out);
}

void deform(Primitive& primitive, const Deforming& pose) {
    if (!primitive.deformation)
        return;
    Vertices moved;
    deform(*primitive.deformation, pose, moved);
    primitive.positions = std::move(moved.positions);
    primitive.normals = std::move(moved.normals);
    primitive.tangents = std::move(moved.tangents);
    for (std::size_t set = 0; set < std::size(moved.uv); ++set)
        if (!moved.uv[set].empty())
            primitive.uv[set] = std::move(moved.uv[set]);
    if (!moved.colors.empty())
        primitive.colors = std::move(moved.colors);
    primitive.bounds = boundsOf(primitive.positions);
}

// A vertex is a mean of where its joints have it, and so inside the box of these, as long as no weight is
// negative.
Box boundsOf(const Deformation& deformation, const Deforming& pose) {
    glm::dvec3 least(0.0), most(0.0); // Of what targets add.
    for (std::size_t t = 0; t < std::min(pose.weights.size(), deformation.targetBoxes.size()); ++t) {
        const double weight = pose.weights[t];
        const glm::dvec3 a = weight * deformation.targetBoxes[t].min,
                         b = weight * deformation.targetBoxes[t].max;
        least += glm::min(a, b);
        most += glm::max(a, b);
    }
    const auto moved = [&](const Box& box) { return Box{box.min + least, box.max + most}; };
    if (pose.joints.empty() || deformation.influencesPerVertex == 0)
        return moved(deformation.box);
    Box bounds;
    for (std::size_t j = 0; j < std::min(deformation.jointBoxes.size(), pose.joints.size()); ++j)
        if (!deformation.jointBoxes[j].empty())
            bounds.add(moved(deformation.jointBoxes[j]), glm::dmat4(glm::mat4(pose.joints[j])));
    return bounds;
}

} // namespace franken
