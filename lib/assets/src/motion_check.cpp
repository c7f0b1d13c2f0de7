// SPDX-License-Identifier: MIT
#include "motion_check.h"

#include "element.h"
#include "finite.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <utility>

namespace franken {
namespace {

Error fault(const std::string& where, const char* what) {
    return {"scene.data", where, what, "see animation.h and deform.h for the values of each member"};
}

Result<void> checkSampler(const AnimationSampler& sampler, const std::string& where) {
    if (sampler.times.empty() || !areFinite(sampler.times) ||
        !std::is_sorted(sampler.times.begin(), sampler.times.end()))
        return fault(where + ".times", "there must be one at least, and they must be finite and ascend");
    if (!areFinite(sampler.values))
        return fault(where + ".values", "they must be finite");
    return {};
}

Result<void> checkChannel(const Scene& scene, const Animation& animation, const AnimationChannel& channel,
                          const std::string& where) {
    if (!isIndex(channel.node, scene.nodes.size()))
        return fault(where + ".node", "there is no such node");
    if (!isIndex(channel.sampler, animation.samplers.size()))
        return fault(where + ".sampler", "there is no such sampler");
    const AnimationSampler& sampler = animation.samplers[static_cast<std::size_t>(channel.sampler)];
    const std::size_t weights = scene.nodes[static_cast<std::size_t>(channel.node)].rest.weights.size();
    const std::size_t parts = sampler.interpolation == AnimationSampler::Interpolation::CubicSpline ? 3 : 1;
    if (sampler.values.size() != sampler.times.size() * parts * widthOf(channel.path, weights))
        return fault(where, "its sampler has another number of values than the channel needs");
    return {};
}

Result<void> checkAnimation(const Scene& scene, const Animation& animation, const std::string& where) {
    if (!std::isfinite(animation.duration))
        return fault(where + ".duration", "it must be finite");
    for (std::size_t s = 0; s < animation.samplers.size(); ++s)
        if (Result<void> checked = checkSampler(animation.samplers[s], elementOf(where + ".samplers", s));
            !checked)
            return checked;
    std::set<std::pair<int, AnimationChannel::Path>> moved;
    for (std::size_t c = 0; c < animation.channels.size(); ++c) {
        const AnimationChannel& channel = animation.channels[c];
        const std::string place = elementOf(where + ".channels", c);
        if (Result<void> checked = checkChannel(scene, animation, channel, place); !checked)
            return checked;
        if (!moved.emplace(channel.node, channel.path).second)
            return fault(place, "a channel before it moves the same");
    }
    return {};
}

Result<void> checkSkin(const Scene& scene, const Skin& skin, const std::string& where) {
    const auto isNode = [&](int node) { return isIndex(node, scene.nodes.size()); };
    if (skin.joints.empty() || !std::all_of(skin.joints.begin(), skin.joints.end(), isNode))
        return fault(where + ".joints", "there must be one at least, and each must be a node");
    if (skin.inverseBinds.size() != skin.joints.size() ||
        !std::all_of(skin.inverseBinds.begin(), skin.inverseBinds.end(), isFinite<glm::mat4>))
        return fault(where + ".inverseBinds", "there must be one for each joint, of finite numbers");
    return {};
}

/// Every array of `changed` is empty, or as long as the one of `whole`.
bool fit(const Vertices& changed, const Vertices& whole) {
    const auto fits = [](const auto& left, const auto& right) {
        return left.empty() ||
               (left.size() == right.size() &&
                std::all_of(left.begin(), left.end(), [](const auto& value) { return isFinite(value); }));
    };
    return fits(changed.positions, whole.positions) && fits(changed.normals, whole.normals) &&
           fits(changed.tangents, whole.tangents) && fits(changed.uv[0], whole.uv[0]) &&
           fits(changed.uv[1], whole.uv[1]) && fits(changed.colors, whole.colors);
}

bool areInfluences(const Deformation& deformation, std::size_t vertices) {
    constexpr std::uint32_t kMaxJoints = 65536; // As many as a file can name.
    constexpr double kRounding = 0.01;          // Of weights that were a byte each.
    const std::span<const Influence> all = deformation.influences;
    const std::size_t each = deformation.influencesPerVertex;
    if (each == 0 || all.empty())
        return all.empty() && each * vertices == 0;
    if (all.size() % each != 0 || all.size() / each != vertices)
        return false;
    for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
        double sum = 0;
        for (const auto& [joint, weight] : all.subspan(vertex * each, each)) {
            if (joint >= kMaxJoints || !(weight >= 0))
                return false;
            sum += weight;
        }
        if (!(std::abs(sum - 1) <= kRounding))
            return false;
    }
    return true;
}

Result<void> checkDeformation(const Primitive& primitive, const std::string& where) {
    const Deformation& deformation = *primitive.deformation;
    const Vertices& bind = deformation.bind;
    const std::size_t vertices = primitive.positions.size();
    const auto hasAll = [&](const auto& values) { return values.empty() || values.size() == vertices; };
    if (bind.positions.size() != vertices || bind.normals.size() != vertices || !hasAll(bind.tangents) ||
        bind.tangents.size() != primitive.tangents.size() || !hasAll(bind.uv[0]) || !hasAll(bind.uv[1]) ||
        !hasAll(bind.colors) || !fit(bind, bind))
        return fault(where + ".bind", "it must have finite values of as many vertices as the primitive");
    for (std::size_t t = 0; t < deformation.targets.size(); ++t)
        if (!fit(deformation.targets[t], bind))
            return fault(elementOf(where + ".targets", t),
                         "each of its arrays must be empty or fit that of bind, and be finite");
    if (!areInfluences(deformation, vertices))
        return fault(where + ".influences",
                     "there must be influencesPerVertex of them for each vertex, of joints "
                     "below 65,536 and weights of 0 or more that add up to 1");
    if (deformation.flat && vertices % 3 != 0)
        return fault(where + ".flat", "there must be three vertices for each triangle");
    return {};
}

std::size_t jointsOf(const Deformation& deformation) {
    std::size_t joints = 0;
    for (const Influence& influence : deformation.influences)
        joints = std::max<std::size_t>(joints, influence.joint + std::size_t{1});
    return joints;
}

Result<void> checkSkinOf(const Scene& scene, const Instance& instance, const std::string& where) {
    if (instance.skin == kNone)
        return {};
    if (!isIndex(instance.skin, scene.skins.size()) || instance.nodeIndex == kNone)
        return fault(where + ".skin", "there is no such skin, or the instance has no node");
    const std::size_t joints = scene.skins[static_cast<std::size_t>(instance.skin)].joints.size();
    for (const Primitive& primitive : scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives) {
        if (!primitive.deformation || primitive.deformation->influences.empty())
            return fault(where + ".skin", "a primitive of its mesh has no joints: it needs an instance of "
                                          "its own, without the skin");
        if (jointsOf(*primitive.deformation) > joints)
            return fault(where + ".skin", "a vertex of its mesh names a joint that it does not have");
    }
    return {};
}

Result<void> checkDeformations(const Scene& scene) {
    for (std::size_t m = 0; m < scene.meshes.size(); ++m)
        for (std::size_t p = 0; p < scene.meshes[m].primitives.size(); ++p)
            if (const Primitive& primitive = scene.meshes[m].primitives[p]; primitive.deformation)
                if (Result<void> checked = checkDeformation(
                        primitive, elementOf(elementOf("meshes", m) + ".primitives", p) + ".deformation");
                    !checked)
                    return checked;
    for (std::size_t i = 0; i < scene.instances.size(); ++i)
        if (Result<void> checked = checkSkinOf(scene, scene.instances[i], elementOf("instances", i));
            !checked)
            return checked;
    return {};
}

} // namespace

Result<void> checkMotion(const Scene& scene) {
    for (std::size_t n = 0; n < scene.nodes.size(); ++n)
        if (scene.nodes[n].parent != kNone && !isIndex(scene.nodes[n].parent, n))
            return fault(elementOf("nodes", n) + ".parent", "it must be a node before this one");
    for (std::size_t k = 0; k < scene.skins.size(); ++k)
        if (Result<void> checked = checkSkin(scene, scene.skins[k], elementOf("skins", k)); !checked)
            return checked;
    if (Result<void> checked = checkDeformations(scene); !checked)
        return checked;
    for (std::size_t a = 0; a < scene.animations.size(); ++a)
        if (Result<void> checked = checkAnimation(scene, scene.animations[a], elementOf("animations", a));
            !checked)
            return checked;
    return {};
}

} // namespace franken
