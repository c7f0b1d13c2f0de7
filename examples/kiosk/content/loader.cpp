// SPDX-License-Identifier: MIT
#include "kiosk/content/loader.h"

#include "franken/file.h"
#include "franken/gltf.h"
#include "franken/pose.h"
#include "franken/printable.h"

#include <algorithm>
#include <cmath>

namespace kiosk {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMaxCaptionBytes = 4096;

constexpr std::size_t kMoments = 12;      // Of an animation, at which a model is measured.
constexpr std::size_t kMostMoments = 120; // Of all of them, however many there are.

/// What a scene passes through as it turns about an upright axis.
class Swept {
public:
    explicit Swept(const glm::dvec3& middle) : m_middle(middle), m_low(middle.y), m_high(middle.y) {}

    void add(const franken::Scene& scene) {
        for (const franken::Instance& instance : scene.instances)
            if (instance.visible)
                for (const franken::Primitive& primitive :
                     scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives)
                    for (const glm::vec3& position : primitive.positions)
                        add(glm::dvec3(instance.world * glm::dvec4(position, 1)));
    }

    franken::Box box() const {
        return {.min = {m_middle.x - m_radius, m_low, m_middle.z - m_radius},
                .max = {m_middle.x + m_radius, m_high, m_middle.z + m_radius}};
    }

private:
    void add(const glm::dvec3& point) {
        m_radius = std::max(m_radius, std::hypot(point.x - m_middle.x, point.z - m_middle.z));
        m_low = std::min(m_low, point.y);
        m_high = std::max(m_high, point.y);
    }

    glm::dvec3 m_middle;
    double m_low, m_high, m_radius = 0;
};

franken::Scene withoutMeshes(const franken::Scene& scene) {
    franken::Scene still;
    still.cameras = scene.cameras;
    still.lights = scene.lights;
    still.nodes = scene.nodes;
    still.animations = scene.animations;
    return still;
}

/// Leaves the scene as it was.
franken::Box sweptBy(franken::Scene& scene, const std::stop_token& cancel) {
    const franken::Box box = scene.bounds();
    Swept swept(0.5 * (box.min + box.max));
    swept.add(scene);
    if (scene.animations.empty())
        return swept.box();
    const std::size_t count = scene.animations.size(), all = std::min(count * kMoments, kMostMoments);
    const franken::Pose rest = franken::restPose(scene);
    for (std::size_t moment = 0; moment < all && !cancel.stop_requested(); ++moment) {
        const std::size_t animation = moment % count, share = moment / count;
        const double duration = scene.animations[animation].duration;
        franken::Pose pose = rest;
        if (franken::sample(scene, static_cast<int>(animation),
                            duration * static_cast<double>(share) / kMoments, pose) &&
            franken::applyPose(scene, pose))
            swept.add(scene);
    }
    [[maybe_unused]] const auto rested = franken::applyPose(scene, rest);
    return swept.box();
}

} // namespace

LoadedModel loadModel(const fs::path& path, const std::stop_token& cancel,
                      const std::function<void(float)>& progress) {
    LoadedModel model{.path = path,
                      .scene = franken::Scene{},
                      .still = {},
                      .swept = {},
                      .caption = captionOf(path),
                      .warnings = {}};
    const auto log = [&model](franken::LogLevel level, std::string_view text) {
        if (level != franken::LogLevel::Info)
            model.warnings.emplace_back(text);
    };
    const auto done = [&progress](float share, std::string_view) { progress(share); };
    model.scene = franken::loadGltf(path,
                                    {.images = franken::ImageForm::Encoded,
                                     .progress = progress ? franken::LoadProgress(done) : nullptr,
                                     .cancel = cancel},
                                    log);
    if (!model.scene)
        return model;
    if (model.scene->bounds().empty()) {
        model.scene =
            franken::Error{"kiosk.nothing", path.string(), "the model holds nothing that can be drawn",
                           "see its warnings, or whether its scene has a mesh of triangles"};
        return model;
    }
    model.swept = sweptBy(*model.scene, cancel);
    model.still = withoutMeshes(*model.scene);
    return model;
}

std::string captionOf(const fs::path& model) {
    fs::path beside = model;
    if (const auto text = franken::readFile(beside.replace_extension(".txt"), kMaxCaptionBytes)) {
        const std::string all(text->begin(), text->end());
        const std::string_view body = franken::withoutByteOrderMark(all);
        return franken::printable(body.substr(0, body.find_first_of("\r\n")));
    }
    std::string name = model.stem().string();
    std::replace_if(
        name.begin(), name.end(), [](char letter) { return letter == '_' || letter == '-'; }, ' ');
    return franken::printable(name);
}

} // namespace kiosk
