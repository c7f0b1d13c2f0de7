// SPDX-License-Identifier: MIT
#include "scene_loader.h"

#include "franken/guard.h"
#include "franken/scene_check.h"

namespace franken {

Outline outlineOf(const Scene& scene, const std::map<int, Material>& changedMaterials) {
    Outline outline = outlineOf(scene);
    for (const auto& [index, material] : changedMaterials)
        if (static_cast<std::size_t>(index) < outline.scene.materials.size() &&
            check(outline.scene, material))
            outline.scene.materials[static_cast<std::size_t>(index)] = material;
    return outline;
}

SceneLoader::SceneLoader(LoaderInput input)
    : m_thread([this, input = std::move(input)](const std::stop_token& stop) { run(stop, input); }) {}

void SceneLoader::run(const std::stop_token& stop, LoaderInput input) {
    Result<void> result = guarded("the source of a model", [&] { return produce(stop, input); });
    const std::scoped_lock lock(m_shared.mutex);
    m_shared.result = std::move(result);
    m_shared.ended = true;
}

Result<void> SceneLoader::produce(const std::stop_token& stop, LoaderInput& input) {
    if (!input.scene) {
        Result<Scene> scene = input.source();
        if (!scene)
            return scene.error();
        input.scene = std::make_shared<const Scene>(*std::move(scene));
    }
    m_scene = input.scene;
    const Log log = [this](LogLevel level, std::string_view text) {
        const std::scoped_lock lock(m_shared.mutex);
        m_shared.messages.emplace_back(level, text);
    };
    Result<SceneData> data = SceneData::make(
        {input.scene, outlineOf(*input.scene, input.changedMaterials), input.capabilities, log});
    if (!data)
        return data.error();
    const auto mayGoOn = [this] { return m_shared.waiting <= kMostWaiting; };
    while (!stop.stop_requested()) {
        std::optional<Piece> piece = data->next();
        std::unique_lock lock(m_shared.mutex);
        if (!piece) {
            m_shared.plan = data->takePlan();
            m_shared.outline = data->outline();
            return {};
        }
        m_shared.waiting += bytesOf(*piece);
        m_shared.pieces.push_back(*std::move(piece));
        m_shared.changed.wait(lock, stop, mayGoOn);
    }
    return {};
}

bool SceneLoader::isReady() {
    const std::scoped_lock lock(m_shared.mutex);
    m_shared.waiting -= std::exchange(m_shared.taken, 0);
    m_shared.changed.notify_all();
    return m_shared.ended || !m_shared.pieces.empty();
}

Result<std::optional<Piece>> SceneLoader::take() {
    const std::scoped_lock lock(m_shared.mutex);
    if (m_shared.pieces.empty())
        return m_shared.result ? Result<std::optional<Piece>>(std::nullopt) : m_shared.result.error();
    std::optional<Piece> piece = std::move(m_shared.pieces.front());
    m_shared.pieces.pop_front();
    m_shared.taken = bytesOf(*piece);
    return piece;
}

std::vector<std::pair<LogLevel, std::string>> SceneLoader::takeMessages() {
    const std::scoped_lock lock(m_shared.mutex);
    return std::exchange(m_shared.messages, {});
}

GpuScene SceneLoader::takePlan() {
    const std::scoped_lock lock(m_shared.mutex);
    return std::move(m_shared.plan);
}

Outline SceneLoader::takeOutline() {
    const std::scoped_lock lock(m_shared.mutex);
    return std::move(m_shared.outline);
}

bool SceneLoader::hasEnded() {
    const std::scoped_lock lock(m_shared.mutex);
    return m_shared.ended;
}

} // namespace franken
