// SPDX-License-Identifier: MIT
// Any keys and times as an animation of three nodes with a skin: refused by check(), or sampled to a pose
// that is one of the scene's, has each key's own value on the key, and moves vertices.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>

#include "franken/deform.h"
#include "franken/pose.h"
#include "franken/scene_check.h"
#include "require.h"

namespace {

using namespace franken;
using Path = AnimationChannel::Path;
using Interpolation = AnimationSampler::Interpolation;

/// Reads values off the front of the bytes; zeros follow their end.
class Bytes {
public:
    Bytes(const std::uint8_t* data, std::size_t size) : m_next(data), m_left(size) {}

    template<typename Value>
    Value take() {
        Value value{};
        const std::size_t size = std::min(sizeof(Value), m_left);
        std::memcpy(&value, m_next, size);
        m_next += size;
        m_left -= size;
        return value;
    }
    bool isEmpty() const { return m_left == 0; }

private:
    const std::uint8_t* m_next;
    std::size_t m_left;
};

constexpr std::size_t kWeights = 2;

/// The first node's vertices hang on the two others.
Scene skinned() {
    Scene scene;
    scene.nodes = {Node{.rest = {.weights = std::vector<float>(kWeights)}}, Node{}, Node{.parent = 1}};
    scene.skins = {{.joints = {1, 2}, .inverseBinds = {glm::mat4(1), glm::mat4(1)}}};
    return scene;
}

Deformation deformation() {
    Vertices target;
    target.positions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    Deformation result{.targets = {target, target}, .influencesPerVertex = 2};
    result.bind.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    result.bind.normals.assign(3, {0, 0, 1});
    result.influences = {{0, 1}, {1, 0}, {0, 0.5f}, {1, 0.5f}, {1, 1}, {0, 0}};
    measure(result);
    return result;
}

Animation animationOf(Bytes& bytes) {
    Animation animation;
    const int channels = 1 + bytes.take<std::uint8_t>() % 4;
    for (int i = 0; i < channels; ++i) {
        AnimationChannel channel{.sampler = i};
        channel.path = static_cast<Path>(bytes.take<std::uint8_t>() % 5);
        channel.node = channel.path == Path::Weights ? 0 : bytes.take<std::uint8_t>() % 3;
        AnimationSampler sampler;
        sampler.interpolation = static_cast<Interpolation>(bytes.take<std::uint8_t>() % 3);
        const std::size_t width =
            widthOf(channel.path, kWeights) * (sampler.interpolation == Interpolation::CubicSpline ? 3 : 1);
        const std::size_t keys = bytes.take<std::uint8_t>() % 8;
        for (std::size_t key = 0; key < keys; ++key) {
            sampler.times.push_back(bytes.take<float>());
            for (std::size_t value = 0; value < width; ++value)
                sampler.values.push_back(bytes.take<float>());
        }
        if (!sampler.times.empty())
            animation.duration = std::max(animation.duration, sampler.times.back());
        const auto movesTheSame = [&](const AnimationChannel& other) {
            return other.path == channel.path && other.node == channel.node;
        };
        if (std::any_of(animation.channels.begin(), animation.channels.end(), movesTheSame))
            return animation;
        animation.channels.push_back(channel);
        animation.samplers.push_back(std::move(sampler));
    }
    return animation;
}

/// Rotations come out in unit length, and visibility as a bool.
void checkKeys(const Scene& scene, const AnimationChannel& channel) {
    if (channel.path != Path::Translation && channel.path != Path::Scale)
        return;
    const AnimationSampler& sampler = scene.animations[0].samplers[static_cast<std::size_t>(channel.sampler)];
    const bool isCubic = sampler.interpolation == Interpolation::CubicSpline;
    Pose pose;
    for (std::size_t key = 0; key < sampler.times.size(); ++key) {
        if (key + 1 < sampler.times.size() && sampler.times[key] == sampler.times[key + 1])
            continue; // Of several at one time, the last one counts.
        require(sample(scene, 0, sampler.times[key], pose).has_value(), "a finite time is sampled");
        const Transform& local = pose.nodes[static_cast<std::size_t>(channel.node)].local;
        const glm::dvec3& found = channel.path == Path::Scale ? local.scale : local.translation;
        const float* const values = sampler.values.data() + key * (isCubic ? 9 : 3) + (isCubic ? 3 : 0);
        for (int i = 0; i < 3; ++i)
            require(std::abs(found[i] - values[i]) <= 1e-6 * std::abs(double{values[i]}),
                    "a key's own value");
    }
}

void checkAt(const Scene& scene, double seconds, Ends ends) {
    Pose pose;
    const Result<void> sampled = sample(scene, 0, seconds, pose, ends);
    require(sampled.has_value() == std::isfinite(seconds), "every finite time is sampled, and no other");
    if (!sampled)
        return;
    if (const Result<void> checked = check(scene, pose); !checked) {
        require(checked.error().code == "pose.nodes", "a documented code");
        return; // Numbers near the largest float, whose spline goes beyond.
    }
    std::vector<NodeWorld> worlds;
    worldsOf(scene, pose, worlds);
    Palette palette;
    paletteOf(scene.skins[0], worlds, palette);
    static const Deformation moves = deformation();
    Vertices vertices;
    deform(moves, {.weights = pose.nodes[0].weights, .joints = palette.joints}, vertices);
    require(vertices.positions.size() == 3 && vertices.normals.size() == 3, "all vertices");
    Pose mixed;
    require(mix(pose, restPose(scene), 0.25, mixed).has_value(), "poses of one scene mix");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Bytes bytes(data, size);
    Scene scene = skinned();
    scene.animations = {animationOf(bytes)};
    if (!check(scene))
        return 0;
    for (const AnimationChannel& channel : scene.animations[0].channels)
        checkKeys(scene, channel);
    do
        for (const Ends ends : {Ends::Hold, Ends::Loop})
            checkAt(scene, bytes.take<float>(), ends);
    while (!bytes.isEmpty());
    return 0;
}
