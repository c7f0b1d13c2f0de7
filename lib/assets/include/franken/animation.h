// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/ext/matrix_double4x4.hpp>
#include <glm/ext/quaternion_double.hpp>
#include <glm/ext/vector_double3.hpp>

#include "franken/api.h"
#include "franken/index.h"

/// The nodes of a scene and their animations, as plain data: glTF 2.0, 3.5 (nodes) and 3.11 (animations).
namespace FRANKEN_API franken {

/// From a node to its parent: scaled, then turned, then moved.
struct Transform {
    glm::dvec3 translation{0.0};             ///< Metres.
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0}; ///< Any length; 0 turns nothing.
    glm::dvec3 scale{1.0};                   ///< By axis; any sign.
    bool operator==(const Transform&) const = default;
};

/// T * R * S.
glm::dmat4 matrixOf(const Transform& transform);

/// What animations change of a node.
struct NodeState {
    Transform local = {};            ///< From the node to its parent.
    bool visible = true;             ///< KHR_node_visibility: hides the nodes below as well.
    std::vector<float> weights = {}; ///< Of its mesh's morph targets, one for each; empty for a mesh without.
    bool operator==(const NodeState&) const = default;
};

/// A place in the tree, on which meshes, cameras, lights and joints hang.
struct Node {
    std::string name = {}; ///< As in the file; not unique.
    int index = kNone;     ///< In the file's array of nodes.
    int parent = kNone;    ///< Index into Scene::nodes, below the node's own; kNone for a root.
    NodeState rest = {};   ///< What it is where no animation moves it.
    /// A matrix that no Transform says, because it shears: it stands in place of `local` in every pose.
    std::optional<glm::dmat4> matrix = {};
};

/// Values over time. Outside its keys, the first and the last value hold.
struct AnimationSampler {
    /// How values between two keys are found.
    enum class Interpolation {
        Step,        ///< The value of the key before.
        Linear,      ///< Rotations: along the shorter arc (slerp).
        CubicSpline, ///< Hermite; each key has an in-tangent, a value and an out-tangent.
    };

    Interpolation interpolation = Interpolation::Linear;
    std::vector<float> times = {}; ///< Seconds, ascending; at least one.
    /// For each key as many numbers as the channel's path has (thrice as many for CubicSpline).
    std::vector<float> values = {};
};

/// What a sampler moves.
struct AnimationChannel {
    /// What of a node is moved, and by how many numbers.
    enum class Path {
        Translation, ///< 3 numbers.
        Rotation,    ///< 4: x, y, z, w.
        Scale,       ///< 3.
        Weights,     ///< As many as the node has.
        Visible,     ///< 1; 0 hides. KHR_animation_pointer to KHR_node_visibility.
    };

    int sampler = 0; ///< Index into Animation::samplers.
    int node = 0;    ///< Index into Scene::nodes.
    Path path = Path::Translation;
};

/// An animation of a file: what moves together.
struct Animation {
    std::string name = {};                       ///< As in the file; not unique.
    int index = kNone;                           ///< In the file's array of animations.
    std::vector<AnimationSampler> samplers = {}; ///< What the channels refer to.
    std::vector<AnimationChannel> channels = {}; ///< No two of them move the same.
    float duration = 0;                          ///< Seconds: the latest key of all channels.
};

/// How many numbers a key of that path has; `weights` is for Path::Weights.
std::size_t widthOf(AnimationChannel::Path path, std::size_t weights);

} // namespace franken
