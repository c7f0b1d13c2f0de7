// SPDX-License-Identifier: MIT
#include <algorithm>

#include <glm/geometric.hpp>

#include "finite.h"
#include "gltf/accessor.h"
#include "gltf/mesh.h"

namespace franken::gltf {
namespace {

// Of a tangent, the first three: a target never flips the handedness.
template<typename Vector>
bool addDeltas(Document& source, int accessor, float weight, std::vector<Vector>& to) {
    std::vector<glm::vec3> deltas;
    if (!source.charge(to.size(), sizeof(glm::vec3), pathOf("accessors", accessor)) ||
        !readVectors(source, accessor, deltas))
        return false;
    for (std::size_t i = 0; i < to.size(); ++i)
        for (int c = 0; c < 3; ++c)
            to[i][c] += weight * deltas[i][c];
    return true;
}

// What a normal turns by: the inverse transpose, up to a positive factor, as cofactors, so that a joint
// scaled to nothing does no harm.
glm::mat3 cofactors(const glm::mat4& matrix) {
    const glm::vec3 x(matrix[0]), y(matrix[1]), z(matrix[2]);
    const glm::mat3 result(glm::cross(y, z), glm::cross(z, x), glm::cross(x, y));
    return glm::dot(x, result[0]) < 0.0f ? -result : result;
}

bool checkFinitePositions(Document& source, const std::string& where, const Primitive& primitive) {
    for (const glm::vec3& position : primitive.positions)
        if (!isFinite(position))
            return source.fail("gltf.value", where, "the pose moves a vertex out of the range of floats");
    return true;
}

} // namespace

bool applyMorph(Document& source, const tinygltf::Primitive& from, const std::string& where,
                const std::vector<double>& weights, Primitive& primitive) {
    const std::size_t count = std::min(weights.size(), from.targets.size());
    for (std::size_t t = 0; t < count; ++t) {
        const float weight = static_cast<float>(weights[t]);
        if (weight == 0.0f)
            continue;
        for (const auto& [name, accessor] : from.targets[t]) {
            bool read = true;
            if (name == "POSITION")
                read = addDeltas(source, accessor, weight, primitive.positions);
            else if (name == "NORMAL" && !primitive.normals.empty())
                read = addDeltas(source, accessor, weight, primitive.normals);
            else if (name == "TANGENT" && !primitive.tangents.empty())
                read = addDeltas(source, accessor, weight, primitive.tangents);
            else if (name != "NORMAL" && name != "TANGENT")
                source.warnOnce(kLeftOut, "morph targets of " + name + " are left out");
            if (!read)
                return false;
        }
    }
    return checkFinitePositions(source, where, primitive);
}

bool applySkin(Document& source, const tinygltf::Primitive& from, const std::string& where,
               const std::vector<glm::mat4>& joints, Primitive& primitive) {
    const auto jointsAt = from.attributes.find("JOINTS_0"), weightsAt = from.attributes.find("WEIGHTS_0");
    if (jointsAt == from.attributes.end() || weightsAt == from.attributes.end()) {
        source.warn(kMended, where, "a skinned mesh has no JOINTS_0 and WEIGHTS_0: drawn without its skin");
        return true;
    }
    std::vector<glm::uvec4> numbers;
    std::vector<glm::vec4> weights;
    if (!source.charge(primitive.positions.size(), sizeof(glm::uvec4) + sizeof(glm::vec4), where) ||
        !readJoints(source, jointsAt->second, numbers) || !readVectors(source, weightsAt->second, weights))
        return false;
    if (from.attributes.contains("JOINTS_1"))
        source.warnOnce(kLeftOut, "more than four joints for a vertex are left out");
    for (std::size_t i = 0; i < primitive.positions.size(); ++i) {
        glm::mat4 blended(0.0f);
        const float sum = weights[i].x + weights[i].y + weights[i].z + weights[i].w;
        for (int j = 0; j < 4; ++j) {
            if (weights[i][j] == 0.0f)
                continue; // its joint may be anything
            if (numbers[i][j] >= joints.size())
                return source.fail("gltf.index-range", where + "/attributes/JOINTS_0",
                                   "vertex " + std::to_string(i) + " names joint " +
                                       std::to_string(numbers[i][j]) + " of " +
                                       std::to_string(joints.size()));
            blended += weights[i][j] / sum * joints[numbers[i][j]];
        }
        if (sum == 0.0f)
            blended = joints[0];
        primitive.positions[i] = glm::vec3(blended * glm::vec4(primitive.positions[i], 1.0f));
        if (!primitive.normals.empty())
            primitive.normals[i] = cofactors(blended) * primitive.normals[i];
        if (!primitive.tangents.empty())
            primitive.tangents[i] =
                glm::vec4(glm::mat3(blended) * glm::vec3(primitive.tangents[i]), primitive.tangents[i].w);
    }
    return checkFinitePositions(source, where, primitive);
}

} // namespace franken::gltf
