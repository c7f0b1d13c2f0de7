// SPDX-License-Identifier: MIT
#include "kiosk/content/loader.h"

#include "franken/file.h"
#include "franken/gltf.h"
#include "franken/printable.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

namespace kiosk {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMaxCaptionBytes = 4096;

franken::Box sweptBy(const franken::Scene& scene) {
    const franken::Box box = scene.bounds();
    const glm::dvec3 middle = 0.5 * (box.min + box.max);
    double radius = 0;
    for (const franken::Instance& instance : scene.instances)
        for (const franken::Primitive& primitive :
             scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives)
            for (const glm::vec3& position : primitive.positions) {
                const glm::dvec3 point = glm::dvec3(instance.world * glm::dvec4(position, 1)) - middle;
                radius = instance.visible ? std::max(radius, std::hypot(point.x, point.z)) : radius;
            }
    const glm::dvec3 half(radius, box.max.y - middle.y, radius);
    return {.min = middle - half, .max = middle + half};
}

LoadedModel load(const fs::path& path, const std::stop_token& cancel) {
    LoadedModel model{
        .path = path, .scene = franken::Scene{}, .swept = {}, .caption = captionOf(path), .warnings = {}};
    const auto log = [&model](franken::LogLevel level, std::string_view text) {
        if (level != franken::LogLevel::Info)
            model.warnings.emplace_back(text);
    };
    model.scene = franken::loadGltf(
        path, {.images = franken::ImageForm::Encoded, .progress = {}, .cancel = cancel}, log);
    if (!model.scene)
        return model;
    model.swept = sweptBy(*model.scene);
    if (model.scene->bounds().empty())
        model.scene =
            franken::Error{"kiosk.nothing", path.string(), "the model holds nothing that can be drawn",
                           "see its warnings, or whether its scene has a mesh of triangles"};
    return model;
}

} // namespace

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

Loader::Loader()
    : m_done(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)),
      m_thread([this](const std::stop_token& stop) { run(stop); }) {}

Loader::~Loader() {
    cancel();
    m_thread.request_stop();
    m_thread.join();
    close(m_done);
}

void Loader::request(const fs::path& path) {
    const std::lock_guard lock(m_mutex);
    m_reading.request_stop();
    m_requested = path;
    m_loaded.reset();
    m_wake.notify_one();
}

void Loader::cancel() {
    const std::lock_guard lock(m_mutex);
    m_reading.request_stop();
    m_requested.reset();
    m_loaded.reset();
}

std::optional<LoadedModel> Loader::take() {
    eventfd_t count = 0;
    eventfd_read(m_done, &count);
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_loaded, std::nullopt);
}

void Loader::run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        fs::path path;
        std::stop_token cancelled;
        {
            std::unique_lock lock(m_mutex);
            if (!m_wake.wait(lock, stop, [this] { return m_requested.has_value(); }))
                return;
            path = *std::exchange(m_requested, std::nullopt);
            m_reading = std::stop_source();
            cancelled = m_reading.get_token();
        }
        LoadedModel model = load(path, cancelled);
        const std::lock_guard lock(m_mutex);
        if (cancelled.stop_requested())
            continue;
        m_loaded = std::move(model);
        eventfd_write(m_done, 1);
    }
}

} // namespace kiosk
