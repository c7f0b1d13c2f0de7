// SPDX-License-Identifier: MIT
#include "plain_figure.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/mat4x3.hpp>

#include <algorithm>
#include <cmath>

namespace franken::bench {
namespace {

constexpr float kStep = 0.1f; ///< From joint to joint, along Y.

/// A turn of a joint at a key.
glm::vec4 rotationAt(int joint, int key) {
    const double angle = 0.2 * std::sin(0.7 * joint + 6.283185307 * key / (kKeys - 1));
    const glm::dvec3 axis = glm::normalize(glm::dvec3(1, 0.1 * joint, 0.5));
    return glm::vec4(glm::dvec4(std::sin(angle / 2) * axis, std::cos(angle / 2)));
}

glm::mat4 inverseBind(int joint) {
    return glm::translate(glm::mat4(1), glm::vec3(0, -kStep * static_cast<float>(joint), 0));
}

} // namespace

Scene figureScene() {
    Scene scene;
    Skin skin;
    Animation animation;
    for (int joint = 0; joint < kJoints; ++joint) {
        scene.nodes.push_back({.parent = joint - 1,
                               .rest = {.local = {.translation = {0, joint == 0 ? 0 : double{kStep}, 0}}}});
        skin.joints.push_back(joint);
        skin.inverseBinds.push_back(inverseBind(joint));
        AnimationSampler sampler;
        for (int key = 0; key < kKeys; ++key) {
            sampler.times.push_back(static_cast<float>(kDuration * key / (kKeys - 1)));
            const glm::vec4 rotation = rotationAt(joint, key);
            sampler.values.insert(sampler.values.end(), {rotation.x, rotation.y, rotation.z, rotation.w});
        }
        animation.samplers.push_back(std::move(sampler));
        animation.channels.push_back(
            {.sampler = joint, .node = joint, .path = AnimationChannel::Path::Rotation});
    }
    animation.duration = static_cast<float>(kDuration);
    scene.skins = {std::move(skin)};
    scene.animations = {std::move(animation)};
    return scene;
}

std::shared_ptr<const Deformation> figureDeformation() {
    Deformation deformation{.bind = {}, .influencesPerVertex = kInfluences};
    for (std::size_t v = 0; v < kVertices; ++v) {
        const float along = static_cast<float>(v) / kVertices * (kJoints - 1);
        const float angle = 0.61f * static_cast<float>(v);
        const glm::vec3 out(std::cos(angle), 0, std::sin(angle));
        deformation.bind.positions.push_back(0.2f * out + glm::vec3(0, kStep * along, 0));
        deformation.bind.normals.push_back(out);
        const int first = std::clamp(static_cast<int>(along) - 1, 0, kJoints - static_cast<int>(kInfluences));
        constexpr std::array<float, kInfluences> kWeights = {0.1f, 0.4f, 0.35f, 0.15f};
        for (std::size_t i = 0; i < kInfluences; ++i)
            deformation.influences.push_back(
                {static_cast<std::uint32_t>(first) + static_cast<std::uint32_t>(i), kWeights[i]});
    }
    return std::make_shared<const Deformation>(std::move(deformation));
}

PlainFigure::PlainFigure() : positions(kVertices), normals(kVertices) {
    for (int joint = 0; joint < kJoints; ++joint)
        for (int key = 0; key < kKeys; ++key)
            m_rotations[static_cast<std::size_t>(joint)][static_cast<std::size_t>(key)] =
                rotationAt(joint, key);
    const std::shared_ptr<const Deformation> figure = figureDeformation();
    m_bindPositions = figure->bind.positions;
    m_bindNormals = figure->bind.normals;
    m_influences = figure->influences;
}

namespace {

/// As slerp has it, for the small angles of neighbouring keys.
glm::vec4 between(const glm::vec4& a, const glm::vec4& b, float t) {
    const float cosine = glm::dot(a, b);
    if (cosine > 0.9999f)
        return glm::normalize(a + t * (b - a));
    const float angle = std::acos(cosine);
    return (std::sin((1 - t) * angle) * a + std::sin(t * angle) * b) / std::sin(angle);
}

glm::mat3 matrixOf(const glm::vec4& q) {
    return {
        1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.y + q.w * q.z),     2 * (q.x * q.z - q.w * q.y),
        2 * (q.x * q.y - q.w * q.z),     1 - 2 * (q.x * q.x + q.z * q.z), 2 * (q.y * q.z + q.w * q.x),
        2 * (q.x * q.z + q.w * q.y),     2 * (q.y * q.z - q.w * q.x),     1 - 2 * (q.x * q.x + q.y * q.y)};
}

} // namespace

void PlainFigure::move(double seconds) {
    const float at = static_cast<float>(seconds / kDuration * (kKeys - 1));
    const auto key = static_cast<std::size_t>(std::min(static_cast<int>(at), kKeys - 2));
    std::array<glm::mat4x3, kJoints> joints;
    glm::mat3 turn(1);
    glm::vec3 place(0);
    for (std::size_t joint = 0; joint < kJoints; ++joint) {
        if (joint > 0)
            place += turn * glm::vec3(0, kStep, 0);
        turn *= matrixOf(
            between(m_rotations[joint][key], m_rotations[joint][key + 1], at - static_cast<float>(key)));
        const glm::vec3 bound(0, kStep * static_cast<float>(joint), 0);
        joints[joint] = glm::mat4x3(turn[0], turn[1], turn[2], place - turn * bound);
    }
    for (std::size_t v = 0; v < kVertices; ++v) {
        const Influence* const influences = m_influences.data() + v * kInfluences;
        glm::mat4x3 blended = influences[0].weight * joints[influences[0].joint];
        for (std::size_t i = 1; i < kInfluences; ++i)
            blended += influences[i].weight * joints[influences[i].joint];
        positions[v] = blended * glm::vec4(m_bindPositions[v], 1);
        const glm::vec3 &x = blended[0], &y = blended[1], &z = blended[2];
        normals[v] = glm::normalize(glm::mat3(glm::cross(y, z), glm::cross(z, x), glm::cross(x, y)) *
                                    m_bindNormals[v]);
    }
}

} // namespace franken::bench
