// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <span>

#include "animation/rotation.h"
#include "franken/pose.h"

namespace franken {
namespace {

using Path = AnimationChannel::Path;
using Interpolation = AnimationSampler::Interpolation;

/// Two keys and what lies between them.
struct Keys {
    std::size_t before, after; ///< Equal on a key, and outside of all.
    double share = 0;          ///< Of the way from `before` to `after`.
    double distance = 0;       ///< From one to the other, seconds.
};

// Keys are floats: a time that is a key, but for the rounding to one, is that key.
Keys keysAt(const std::vector<float>& times, double seconds) {
    const auto later = std::upper_bound(times.begin(), times.end(), static_cast<float>(seconds));
    if (later == times.begin())
        return {0, 0};
    const auto before = static_cast<std::size_t>(later - times.begin()) - 1;
    if (later == times.end() || times[before] == static_cast<float>(seconds))
        return {before, before};
    const double from = times[before], distance = *later - from;
    return {before, before + 1, std::clamp((seconds - from) / distance, 0.0, 1.0), distance};
}

/// The numbers of a sampler, `width` for each key.
class Values {
public:
    Values(const AnimationSampler& sampler, std::size_t width)
        : m_values(sampler.values),
          m_width(width),
          m_isSpline(sampler.interpolation == Interpolation::CubicSpline) {}

    double at(std::size_t key, std::size_t i) const { return part(key, m_isSpline ? 1 : 0, i); }

    // glTF 2.0, appendix C.4 (step), C.2 (linear) and C.5 (cubic spline).
    double between(const Keys& keys, Interpolation interpolation, std::size_t i) const {
        const double a = at(keys.before, i), b = at(keys.after, i), t = keys.share;
        if (keys.before == keys.after || interpolation == Interpolation::Step)
            return a;
        if (interpolation == Interpolation::Linear)
            return a + t * (b - a);
        const double leaving = keys.distance * part(keys.before, 2, i);
        const double arriving = keys.distance * part(keys.after, 0, i);
        const double t2 = t * t, t3 = t2 * t;
        return (2 * t3 - 3 * t2 + 1) * a + (t3 - 2 * t2 + t) * leaving + (3 * t2 - 2 * t3) * b +
               (t3 - t2) * arriving;
    }

private:
    double part(std::size_t key, std::size_t part, std::size_t i) const {
        return m_values[((m_isSpline ? 3 : 1) * key + part) * m_width + i];
    }

    std::span<const float> m_values;
    std::size_t m_width;
    bool m_isSpline;
};

template<typename Get>
glm::dvec3 vectorOf(Get get) {
    return {get(0), get(1), get(2)};
}

template<typename Get>
glm::dquat quaternionOf(Get get) {
    return {get(3), get(0), get(1), get(2)};
}

glm::dquat rotationAt(const Values& values, const Keys& keys, Interpolation interpolation) {
    const auto key = [&](std::size_t k) {
        return unit(quaternionOf([&](std::size_t i) { return values.at(k, i); }));
    };
    if (interpolation == Interpolation::Linear && keys.before != keys.after)
        return glm::slerp(key(keys.before), key(keys.after), keys.share);
    return unit(quaternionOf([&](std::size_t i) { return values.between(keys, interpolation, i); }));
}

void sampleChannel(const AnimationSampler& sampler, Path path, double seconds, NodeState& state) {
    const Keys keys = keysAt(sampler.times, seconds);
    const Values values(sampler, widthOf(path, state.weights.size()));
    const auto number = [&](std::size_t i) { return values.between(keys, sampler.interpolation, i); };
    switch (path) {
    case Path::Translation:
        state.local.translation = vectorOf(number);
        break;
    case Path::Rotation:
        state.local.rotation = rotationAt(values, keys, sampler.interpolation);
        break;
    case Path::Scale:
        state.local.scale = vectorOf(number);
        break;
    case Path::Weights:
        for (std::size_t i = 0; i < state.weights.size(); ++i)
            state.weights[i] = static_cast<float>(number(i));
        break;
    case Path::Visible:
        state.visible = values.at(keys.before, 0) != 0.0;
        break;
    }
}

double looped(double seconds, double duration) {
    if (duration <= 0.0)
        return 0.0;
    const double rest = std::fmod(seconds, duration);
    return rest < 0.0 ? rest + duration : rest;
}

bool fits(const Scene& scene, const Pose& pose) {
    return std::equal(scene.nodes.begin(), scene.nodes.end(), pose.nodes.begin(), pose.nodes.end(),
                      [](const Node& node, const NodeState& state) {
                          return node.rest.weights.size() == state.weights.size();
                      });
}

} // namespace

Result<void> sample(const Scene& scene, int animation, double seconds, Pose& pose, Ends ends) {
    if (!isIndex(animation, scene.animations.size()))
        return Error{"pose.animation", std::to_string(animation), "the scene has no such animation",
                     "it has " + std::to_string(scene.animations.size())};
    if (!std::isfinite(seconds))
        return Error{"pose.time", "", "the time is not finite", "pass seconds"};
    if (!fits(scene, pose))
        pose = restPose(scene);
    const Animation& from = scene.animations[static_cast<std::size_t>(animation)];
    const double time = ends == Ends::Loop ? looped(seconds, from.duration) : seconds;
    for (const AnimationChannel& channel : from.channels)
        sampleChannel(from.samplers[static_cast<std::size_t>(channel.sampler)], channel.path, time,
                      pose.nodes[static_cast<std::size_t>(channel.node)]);
    return {};
}

} // namespace franken
