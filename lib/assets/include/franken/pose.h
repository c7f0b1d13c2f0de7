// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <glm/ext/matrix_double4x4.hpp>

#include "franken/api.h"
#include "franken/result.h"
#include "franken/scene.h"

/// Where the nodes of a scene are at a moment.
///
///     Pose walk, run, both;
///     sample(scene, 0, seconds, walk, Ends::Loop);
///     sample(scene, 1, seconds, run, Ends::Loop);
///     mix(walk, run, 0.3, both);                 // a cross-fade
///     renderer.setPose(place, both);
///
/// All functions are pure: safe on any thread, as long as each thread writes poses of its own. They allocate
/// where `pose`, `out` or `worlds` is used for a scene for the first time, and nothing afterwards. They
/// compute in double, from keys that are floats. A scene must be as check() demands.
namespace FRANKEN_API franken {

/// By node, in the order of Scene::nodes. Plain data: an application may turn a wheel by hand.
struct Pose {
    std::vector<NodeState> nodes; ///< As Scene::nodes.
    bool operator==(const Pose&) const = default;
};

/// As the file has it when nothing is animated.
Pose restPose(const Scene& scene);

/// What an animation does before its first key and after its end.
enum class Ends {
    Hold, ///< It stays as it was at the end; before the first key of a channel, as it is there.
    Loop, ///< It begins anew: the time is taken modulo Animation::duration.
};

/// Sets what the animation moves, and leaves the rest of the pose as it is: several animations that move
/// different nodes are sampled one after the other. A pose that does not fit the scene, an empty one for
/// instance, becomes the rest pose first. `animation` is an index into Scene::animations. On a key, to the
/// precision of a float, its own value comes out. Fails, and changes nothing, with "pose.animation" for an
/// unknown index, and with "pose.time" for seconds that are not finite.
Result<void> sample(const Scene& scene, int animation, double seconds, Pose& pose, Ends ends = Ends::Hold);

/// Between two poses of one scene, `t` from 0 (a) to 1 (b): rotations by the shorter arc, visibility by the
/// nearer. `out` may be one of them. Fails with "pose.nodes" where the two do not fit together.
Result<void> mix(const Pose& a, const Pose& b, double t, Pose& out);

/// Fails with "pose.nodes" where the pose is not one of the scene's: another number of nodes or weights, or
/// numbers that are not finite.
Result<void> check(const Scene& scene, const Pose& pose);

/// A node in the world.
struct NodeWorld {
    glm::dmat4 matrix{1.0}; ///< Node to world.
    bool visible = true;    ///< Neither the node nor one above it is hidden.
    bool operator==(const NodeWorld&) const = default;
};

/// Of all nodes; the pose must fit the scene.
void worldsOf(const Scene& scene, const Pose& pose, std::vector<NodeWorld>& worlds);

/// The joints of a skin, each from the mesh to where it is: as seen from the first joint, so that floats can
/// hold it wherever the skin is.
struct Palette {
    glm::dvec3 origin{0.0};               ///< Of the first joint, in the world.
    std::vector<glm::mat4x3> joints = {}; ///< From the skin's bind pose to the world; as Skin::joints.
};
/// Computes the matrices of a skin. Memory of `palette` is used again.
void paletteOf(const Skin& skin, const std::vector<NodeWorld>& worlds, Palette& palette);

/// An instance, a camera and a light of the scene, moved with their nodes; what hangs on no node stays. A
/// skinned instance goes where its first joint is; its vertices are not moved.
void follow(const Scene& scene, const std::vector<NodeWorld>& worlds, Instance& instance);
void follow(const std::vector<NodeWorld>& worlds, Camera& camera);
void follow(const std::vector<NodeWorld>& worlds, Light& light);

/// Moves instances, cameras and lights to where the pose has them, and the vertices of skins and morphs, for
/// good: for what draws one moment of a scene, or looks for what is where. It is how the scene rests from now
/// on (restPose()), and another pose may follow. The vertices of a mesh that several nodes move are those of
/// the last. Renderer::setPose() moves what is on the GPU. Fails as check() does.
Result<void> applyPose(Scene& scene, const Pose& pose);

} // namespace franken
