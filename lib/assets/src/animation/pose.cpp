// SPDX-License-Identifier: MIT
#include "franken/pose.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "animation/node_world.h"
#include "animation/rotation.h"
#include "element.h"
#include "finite.h"

namespace franken {
namespace {

bool hasFiniteNumbers(const NodeState& state) {
    const Transform& local = state.local;
    return isFinite(local.translation) && isFinite(local.rotation) && isFinite(local.scale) &&
           areFinite(state.weights);
}

/// What the pose makes of an instance's vertices.
Deforming deformingOf(const Pose& pose, const Instance& instance, const Palette& palette) {
    Deforming deforming{.mirrored = instance.mirrored};
    if (instance.nodeIndex != kNone)
        deforming.weights = pose.nodes[static_cast<std::size_t>(instance.nodeIndex)].weights;
    if (instance.skin != kNone)
        deforming.joints = palette.joints;
    return deforming;
}

const NodeWorld& worldOf(const std::vector<NodeWorld>& worlds, int node) {
    return worlds[static_cast<std::size_t>(node)];
}

} // namespace

Pose restPose(const Scene& scene) {
    Pose pose;
    pose.nodes.reserve(scene.nodes.size());
    for (const Node& node : scene.nodes)
        pose.nodes.push_back(node.rest);
    return pose;
}

Result<void> mix(const Pose& a, const Pose& b, double t, Pose& out) {
    const auto sameShape = [](const NodeState& left, const NodeState& right) {
        return left.weights.size() == right.weights.size();
    };
    if (!std::equal(a.nodes.begin(), a.nodes.end(), b.nodes.begin(), b.nodes.end(), sameShape))
        return Error{"pose.nodes", "", "the two poses are of different scenes",
                     "sample both of them from one scene"};
    out.nodes.resize(a.nodes.size());
    for (std::size_t n = 0; n < a.nodes.size(); ++n) {
        const NodeState &from = a.nodes[n], &to = b.nodes[n];
        NodeState& state = out.nodes[n];
        const bool visible = t < 0.5 ? from.visible : to.visible;
        const glm::dquat rotation = glm::slerp(unit(from.local.rotation), unit(to.local.rotation), t);
        state.local = {glm::mix(from.local.translation, to.local.translation, t), rotation,
                       glm::mix(from.local.scale, to.local.scale, t)};
        state.visible = visible;
        state.weights.resize(from.weights.size());
        for (std::size_t w = 0; w < state.weights.size(); ++w)
            state.weights[w] = glm::mix(from.weights[w], to.weights[w], static_cast<float>(t));
    }
    return {};
}

Result<void> check(const Scene& scene, const Pose& pose) {
    const auto error = [](std::size_t node, const char* what) {
        return Error{"pose.nodes", elementOf("nodes", node), what,
                     "start from restPose() or sample() of the same scene"};
    };
    if (pose.nodes.size() != scene.nodes.size())
        return error(pose.nodes.size(), "the scene has another number of nodes");
    for (std::size_t n = 0; n < pose.nodes.size(); ++n) {
        if (pose.nodes[n].weights.size() != scene.nodes[n].rest.weights.size())
            return error(n, "the node has another number of weights");
        if (!hasFiniteNumbers(pose.nodes[n]))
            return error(n, "its numbers must be finite");
    }
    return {};
}

NodeWorld below(const NodeWorld& parent, const NodeWorld& local) {
    return {parent.matrix * local.matrix, parent.visible && local.visible};
}

void place(const glm::dmat4& world, Light& light) {
    light.position = glm::dvec3(world[3]);
    if (const glm::dvec3 back(world[2]); glm::length(back) > 0.0)
        light.direction = -glm::normalize(back);
}

void worldsOf(const Scene& scene, const Pose& pose, std::vector<NodeWorld>& worlds) {
    worlds.resize(scene.nodes.size());
    for (std::size_t n = 0; n < worlds.size(); ++n) {
        const Node& node = scene.nodes[n];
        const NodeState& state = pose.nodes[n];
        worlds[n] = {node.matrix ? *node.matrix : matrixOf(state.local), state.visible};
        if (node.parent != kNone)
            worlds[n] = below(worldOf(worlds, node.parent), worlds[n]);
    }
}

// As seen from the first joint, in double: the world, and the way back, may be far away.
void paletteOf(const Skin& skin, const std::vector<NodeWorld>& worlds, Palette& palette) {
    palette.origin = glm::dvec3(worldOf(worlds, skin.joints.front()).matrix[3]);
    palette.joints.resize(skin.joints.size());
    for (std::size_t j = 0; j < skin.joints.size(); ++j) {
        glm::dmat4 world = worldOf(worlds, skin.joints[j]).matrix;
        world[3] -= glm::dvec4(palette.origin, 0);
        palette.joints[j] = glm::mat4x3(world * glm::dmat4(skin.inverseBinds[j]));
    }
}

void follow(const Scene& scene, const std::vector<NodeWorld>& worlds, Instance& instance) {
    if (instance.nodeIndex == kNone)
        return;
    const NodeWorld& node = worldOf(worlds, instance.nodeIndex);
    instance.world = node.matrix * instance.offset;
    instance.mirrored = glm::determinant(glm::dmat3(instance.world)) < 0.0;
    instance.visible = node.visible;
    if (instance.skin == kNone)
        return;
    const Skin& skin = scene.skins[static_cast<std::size_t>(instance.skin)];
    instance.world =
        glm::translate(glm::dmat4(1.0), glm::dvec3(worldOf(worlds, skin.joints.front()).matrix[3]));
}

void follow(const std::vector<NodeWorld>& worlds, Camera& camera) {
    if (camera.nodeIndex != kNone)
        camera.world = worldOf(worlds, camera.nodeIndex).matrix;
}

void follow(const std::vector<NodeWorld>& worlds, Light& light) {
    if (light.nodeIndex != kNone)
        place(worldOf(worlds, light.nodeIndex).matrix, light);
}

Result<void> applyPose(Scene& scene, const Pose& pose) {
    if (Result<void> checked = check(scene, pose); !checked)
        return checked;
    std::vector<NodeWorld> worlds;
    worldsOf(scene, pose, worlds);
    Palette palette;
    for (Instance& instance : scene.instances) {
        follow(scene, worlds, instance);
        if (instance.skin != kNone)
            paletteOf(scene.skins[static_cast<std::size_t>(instance.skin)], worlds, palette);
        for (Primitive& primitive : scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives)
            deform(primitive, deformingOf(pose, instance, palette));
    }
    for (std::size_t n = 0; n < scene.nodes.size(); ++n)
        scene.nodes[n].rest = pose.nodes[n];
    for (Camera& camera : scene.cameras)
        follow(worlds, camera);
    for (Light& light : scene.lights)
        follow(worlds, light);
    return {};
}

} // namespace franken
