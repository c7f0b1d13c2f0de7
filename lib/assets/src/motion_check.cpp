// SPDX-License-Identifier: MIT
#include "motion_check.h"

#include "element.h"
#include "finite.h"

#include <algorithm>
#include <cmath>

namespace franken {
namespace {

Error fault(const std::string& where, const char* what) {
    return {"scene.data", where, what, "see animation.h for the values of each member"};
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
    for (std::size_t c = 0; c < animation.channels.size(); ++c)
        if (Result<void> checked =
                checkChannel(scene, animation, animation.channels[c], elementOf(where + ".channels", c));
            !checked)
            return checked;
    return {};
}

} // namespace

Result<void> checkMotion(const Scene& scene) {
    for (std::size_t n = 0; n < scene.nodes.size(); ++n)
        if (scene.nodes[n].parent != kNone && !isIndex(scene.nodes[n].parent, n))
            return fault(elementOf("nodes", n) + ".parent", "it must be a node before this one");
    for (std::size_t a = 0; a < scene.animations.size(); ++a)
        if (Result<void> checked = checkAnimation(scene, scene.animations[a], elementOf("animations", a));
            !checked)
            return checked;
    return {};
}

} // namespace franken
