// SPDX-License-Identifier: MIT
#include "gltf/animation.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>
#include <utility>

#include "gltf/accessor.h"

namespace franken::gltf {
namespace {

using Path = AnimationChannel::Path;
using Interpolation = AnimationSampler::Interpolation;

struct Target {
    int node; ///< Of the file.
    Path path;
};

std::optional<Path> pathOfWord(std::string_view word) {
    if (word == "translation")
        return Path::Translation;
    if (word == "rotation")
        return Path::Rotation;
    if (word == "scale")
        return Path::Scale;
    if (word == "weights")
        return Path::Weights;
    if (word == "extensions/KHR_node_visibility/visible")
        return Path::Visible;
    return std::nullopt;
}

/// "/nodes/3/rotation" (KHR_animation_pointer).
std::optional<Target> targetOfPointer(std::string_view pointer) {
    constexpr std::string_view kNodes = "/nodes/";
    if (!pointer.starts_with(kNodes))
        return std::nullopt;
    const std::string_view rest = pointer.substr(kNodes.size());
    int node = kNone;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), node);
    const std::string_view tail = rest.substr(static_cast<std::size_t>(end - rest.data()));
    if (error != std::errc() || !tail.starts_with("/"))
        return std::nullopt;
    const std::optional<Path> path = pathOfWord(tail.substr(1));
    return path ? std::optional<Target>({node, *path}) : std::nullopt;
}

/// Reads one animation.
class Reader {
public:
    Reader(Document& source, const NodePlaces& places, const Scene& scene, const Json& from,
           std::string where)
        : m_source(source), m_places(places), m_scene(scene), m_from(from), m_where(std::move(where)) {}

    bool read(Animation& animation) {
        const Json& channels = m_from["channels"];
        constexpr std::size_t kBytes = 2 * (sizeof(AnimationChannel) + sizeof(AnimationSampler)) + 64;
        if (!m_source.charge(channels.size(), kBytes, m_where))
            return false;
        for (std::size_t c = 0; c < channels.size(); ++c)
            if (!readChannel(channels[c], m_where + pathOf("channels", c), animation))
                return false;
        return true;
    }

private:
    bool readChannel(const Json& from, const std::string& where, Animation& animation);
    bool findTarget(const Json& from, const std::string& where, std::optional<Target>& target);
    bool readSampler(int index, std::size_t width, Path path, AnimationSampler& sampler);
    bool readTimes(int accessor, const std::string& where, std::vector<float>& times);
    bool readValues(int accessor, std::size_t count, Path path, const std::string& where,
                    std::vector<float>& values);
    bool readInterpolation(const Json& from, const std::string& where, Interpolation& interpolation);

    Document& m_source;
    const NodePlaces& m_places;
    const Scene& m_scene;
    const Json& m_from;
    std::string m_where;
    std::set<std::pair<int, Path>> m_moved;
};

/// Nothing for a target that is left out: one without a node, or that no pose has.
bool Reader::findTarget(const Json& from, const std::string& where, std::optional<Target>& target) {
    const auto word = from["path"].get<std::string>();
    if (word == "pointer") {
        const Json& pointer = member(member(member(from, "extensions"), "KHR_animation_pointer"), "pointer");
        target = pointer.is_string() ? targetOfPointer(pointer.get<std::string>()) : std::nullopt;
    } else if (from.contains("node")) {
        const std::optional<Path> path = pathOfWord(word);
        if (!path || path == Path::Visible)
            return m_source.fail("gltf.value", where + "/path", "an animation has no path " + word);
        target = {from["node"].get<int>(), *path};
    }
    if (!target)
        m_source.warn(kLeftOut, where, "what the channel animates is not known: it is left out");
    return !target || checkPresent(m_source, target->node, m_places.size(), where + "/node");
}

bool Reader::readChannel(const Json& from, const std::string& where, Animation& animation) {
    const int index = from["sampler"].get<int>();
    std::optional<Target> target;
    if (!checkPresent(m_source, index, m_from["samplers"].size(), where + "/sampler") ||
        !findTarget(from["target"], where + "/target", target))
        return false;
    if (!target)
        return true;
    const int place = m_places[at(target->node)];
    const Node& node = m_scene.nodes[at(place)];
    const std::size_t width = widthOf(target->path, node.rest.weights.size());
    const bool isMatrix = node.matrix && target->path != Path::Weights && target->path != Path::Visible;
    if (width == 0 || isMatrix) {
        m_source.warn(kLeftOut, where,
                      isMatrix ? "the node has a matrix that shears, which an animation cannot move"
                               : "the node has no morph targets, whose weights could move");
        return true;
    }
    if (!m_moved.emplace(place, target->path).second)
        return m_source.fail("gltf.value", where, "two channels of one animation move the same");
    AnimationSampler sampler;
    if (!readSampler(index, width, target->path, sampler))
        return false;
    animation.duration = std::max(animation.duration, sampler.times.back());
    animation.channels.push_back({static_cast<int>(animation.samplers.size()), place, target->path});
    animation.samplers.push_back(std::move(sampler));
    return true;
}

bool Reader::readInterpolation(const Json& from, const std::string& where, Interpolation& interpolation) {
    const std::string word = from.value("interpolation", std::string("LINEAR"));
    if (word == "STEP")
        interpolation = Interpolation::Step;
    else if (word == "CUBICSPLINE")
        interpolation = Interpolation::CubicSpline;
    else if (word != "LINEAR")
        return m_source.fail("gltf.value", where + "/interpolation", "there is no interpolation " + word);
    return true;
}

bool Reader::readSampler(int index, std::size_t width, Path path, AnimationSampler& sampler) {
    const Json& from = m_from["samplers"][at(index)];
    const std::string where = m_where + pathOf("samplers", index);
    const int input = from["input"].get<int>(), output = from["output"].get<int>();
    const std::size_t accessors = m_source.model.accessors.size();
    if (!checkPresent(m_source, input, accessors, where + "/input") ||
        !checkPresent(m_source, output, accessors, where + "/output") ||
        !readInterpolation(from, where, sampler.interpolation) ||
        !readTimes(input, where + "/input", sampler.times))
        return false;
    const std::size_t each = sampler.interpolation == Interpolation::CubicSpline ? 3 * width : width;
    return readValues(output, sampler.times.size() * each, path, where + "/output", sampler.values);
}

bool Reader::readTimes(int index, const std::string& where, std::vector<float>& times) {
    if (!m_source.need(pathOf("accessors", index)))
        return false;
    const tinygltf::Accessor& accessor = m_source.model.accessors[at(index)];
    if (accessor.type != TINYGLTF_TYPE_SCALAR || accessor.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT)
        return m_source.fail("gltf.type", where, "the times of keys are float scalars");
    if (!m_source.charge(accessor.count, sizeof(float), where))
        return false;
    times.resize(accessor.count);
    if (!readFloats(m_source, index, times))
        return false;
    if (!std::is_sorted(times.begin(), times.end()))
        return m_source.fail("gltf.value", where, "the times of keys do not ascend");
    if (times.front() < 0.0f || std::adjacent_find(times.begin(), times.end()) != times.end())
        m_source.warn(
            kMended, where,
            "times of keys are 0 or more, and each is later than the one before; of several keys at "
            "one time, the last counts");
    return true;
}

// The numbers of weights are scalars, all targets of a key one after the other.
bool Reader::readValues(int index, std::size_t count, Path path, const std::string& where,
                        std::vector<float>& values) {
    if (!m_source.need(pathOf("accessors", index)))
        return false;
    tinygltf::Accessor& accessor = m_source.model.accessors[at(index)];
    const bool isFloat = accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT;
    const bool mayBeInteger = accessor.componentType != TINYGLTF_COMPONENT_TYPE_DOUBLE &&
                              accessor.componentType != TINYGLTF_COMPONENT_TYPE_INT &&
                              (path == Path::Rotation || path == Path::Weights || path == Path::Visible);
    const int type = path == Path::Rotation                           ? TINYGLTF_TYPE_VEC4
                     : path == Path::Weights || path == Path::Visible ? TINYGLTF_TYPE_SCALAR
                                                                      : TINYGLTF_TYPE_VEC3;
    if (accessor.type != type || (!isFloat && !mayBeInteger))
        return m_source.fail("gltf.type", where, "the values of keys have another type");
    if (accessor.count * at(width(accessor)) != count)
        return m_source.fail("gltf.type", where,
                             "there are " + std::to_string(accessor.count * at(width(accessor))) +
                                 " numbers, and the keys need " + std::to_string(count));
    if (!isFloat && !accessor.normalized && path != Path::Visible) {
        accessor.normalized = true;
        m_source.warn(kMended, where, "integers are read as normalized, which the accessor does not say");
    }
    if (!m_source.charge(count, sizeof(float), where))
        return false;
    values.resize(count);
    return readFloats(m_source, index, values);
}

/// What costs the animation alone. The memory that it took stays charged, so that the work has an end.
bool isLeftOut(Document& source, const std::string& where) {
    if (source.error->code != "gltf.limit" && source.error->code != "gltf.buffer")
        return source.defer(where);
    source.warn(kLeftOut, where, "the animation is left out: " + source.error->what);
    source.error.reset();
    return true;
}

} // namespace

bool readAnimations(Document& source, const NodePlaces& places, Scene& scene) {
    if (scene.nodes.empty())
        return true;
    for (std::size_t a = 0; a < source.animations.size(); ++a) {
        const Json& from = source.animations[a];
        const std::string where = pathOf("animations", a);
        Animation animation;
        animation.name = from.value("name", std::string());
        animation.index = static_cast<int>(a);
        if (source.faults.contains(where))
            continue;
        if (Reader(source, places, scene, from, where).read(animation))
            scene.animations.push_back(std::move(animation));
        else if (!isLeftOut(source, where))
            return false;
    }
    return true;
}

} // namespace franken::gltf
