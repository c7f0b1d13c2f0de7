// SPDX-License-Identifier: MIT
// Models that come to the GPU step by step.
#include "checked_upload.h"
#include "checks.h"
#include "franken/scene_check.h"
#include "handle.h"
#include "models.h"

#include <algorithm>

namespace franken {

Result<ModelId> Models::addInSteps(Scene scene, SceneSource source) {
    auto model =
        std::make_unique<Model>(Model{newHandle<ModelId>(), std::move(source), outlineOf(scene), {}});
    model->scene = std::make_shared<const Scene>(std::move(scene));
    model->lastShown = m_device.clock;
    m_models.push_back(std::move(model));
    makePlace(*m_models.back(), glm::dmat4(1.0));
    enqueue(*m_models.back());
    return m_models.back()->id;
}

Result<bool> Models::isResident(ModelId id) const {
    const Model* const model = find(id);
    if (model == nullptr)
        return unknownModel();
    if (model->failure)
        return *model->failure;
    return model->gpu.has_value();
}

void Models::enqueue(Model& model) {
    model.failure.reset();
    if (std::find(m_queue.begin(), m_queue.end(), &model) == m_queue.end())
        m_queue.push_back(&model);
}

void Models::dequeue(const Model& model) {
    if (m_loading && m_loading->model == &model)
        cancelLoading();
    std::erase(m_queue, &model);
}

void Models::cancelLoading() {
    if (!m_loading)
        return;
    m_loading->loader->cancel();
    m_ending.push_back(std::move(m_loading->loader));
    m_loading.reset();
    m_device.state.invalidate();
}

bool Models::beginLoading() {
    std::erase_if(m_ending, [](const std::unique_ptr<SceneLoader>& each) { return each->hasEnded(); });
    if (!m_ending.empty() || m_queue.empty())
        return false;
    Model* const model = m_queue.front();
    m_loading.emplace(
        Loading{.model = model,
                .loader = std::make_unique<SceneLoader>(LoaderInput{
                    model->scene, model->source, model->changedMaterials, m_device.capabilities})});
    return true;
}

Result<std::size_t> Models::uploadPart() {
    Loading& loading = *m_loading;
    if (!loading.upload.isIdle())
        return loading.upload.step(m_device, kStepBytes);
    Result<std::optional<Piece>> piece = loading.loader->take();
    if (!piece)
        return piece.error();
    if (*piece) {
        if (Result<void> begun = loading.upload.begin(m_device, *std::move(*piece)); !begun)
            return begun.error();
        return loading.upload.step(m_device, kStepBytes);
    }
    loading.outline = loading.loader->takeOutline();
    loading.gpu = loading.upload.finish(loading.loader->takePlan(), *m_defaults);
    return std::size_t{0};
}

Result<std::size_t> Models::step() {
    if (!m_loading && !beginLoading())
        return std::size_t{0};
    if (m_loading->gpu || isWaiting())
        return std::size_t{0};
    if (m_device.log)
        for (const auto& [level, text] : m_loading->loader->takeMessages())
            m_device.log(level, text);
    Result<std::size_t> bytes = checkedOnce(m_device, [&] { return uploadPart(); });
    if (bytes)
        return bytes;
    Model& model = *m_loading->model;
    cancelLoading();
    if (bytes.error().code == "renderer.memory" && m_device.memory.evictAll())
        return std::size_t{0}; // It is the first of the queue, and begins again.
    noteFailure(model, bytes.error());
    return bytes;
}

bool Models::isWaiting() const {
    if (!m_loading)
        return std::any_of(m_ending.begin(), m_ending.end(),
                           [](const std::unique_ptr<SceneLoader>& each) { return !each->hasEnded(); });
    return !m_loading->gpu && m_loading->upload.isIdle() && !m_loading->loader->isReady();
}

Result<void> Models::finishLoading() {
    Model& model = *m_loading->model;
    model.gpu = std::move(m_loading->gpu);
    model.outline = std::move(m_loading->outline);
    forgetOldNodes(model);
    cancelLoading();
    Result<void> changed = checkedOnce(m_device, [&] {
        Result<void> applied = applyMaterials(model);
        return applied ? applyChanges(model) : applied;
    });
    if (!changed) {
        model.gpu.reset();
        noteFailure(model, changed.error());
        return changed;
    }
    std::erase(m_queue, &model);
    model.scene.reset();
    model.lastShown = m_device.clock;
    setShown(std::move(m_asked));
    return {};
}

void Models::noteFailure(Model& model, const Error& error) {
    if (error.code == contextLost().code)
        return; // It begins again with the next context.
    std::erase(m_queue, &model);
    model.failure = error;
}

/// Materials that were changed since the loader began.
Result<void> Models::applyMaterials(Model& model) {
    Scene& outline = model.outline.scene;
    for (const auto& [index, values] : model.changedMaterials) {
        if (!isIndex(index, outline.materials.size()) || !check(outline, values))
            continue; // The source reads another file now.
        if (Result<void> loaded = checkLoaded(model, index, values); !loaded)
            return loaded;
        outline.materials[static_cast<std::size_t>(index)] = values;
        for (GpuMaterial& material : model.gpu->materials)
            if (material.material == index)
                replan(material, model);
    }
    return {};
}

} // namespace franken
