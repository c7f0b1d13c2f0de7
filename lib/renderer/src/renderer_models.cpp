// SPDX-License-Identifier: MIT
#include "renderer_state.h"

#include <algorithm>
#include <tuple>

namespace franken {

namespace {

Error unknownModel() {
    return {"renderer.model", "", "there is no such model", "use what add() returned, until remove()"};
}

} // namespace

Model* Renderer::State::find(ModelId id) {
    const auto found = std::find_if(models.begin(), models.end(),
                                    [&](const std::unique_ptr<Model>& model) { return model->id == id; });
    return found == models.end() ? nullptr : found->get();
}

bool Renderer::State::isShown(const Model& model) const {
    return std::find(shown.begin(), shown.end(), &model) != shown.end();
}

Result<void> Renderer::State::upload(Model& model, const Scene& scene) {
    thread.check();
    if (lost)
        return noContext();
    glState.invalidate();
    Result<GpuScene> gpu = franken::upload(device(), scene, *defaults);
    if (!gpu)
        return gpu.error();
    if (Result<void> checked = checkMemory(gl); !checked)
        return checked;
    model.gpu = *std::move(gpu);
    return {};
}

Result<void> Renderer::State::makeResident(Model& model) {
    if (model.gpu)
        return {};
    if (!model.source)
        return Error{"renderer.no-source", "", "the context of a model was lost, and it has no source",
                     "hand add() a source that reads the model again"};
    const Result<Scene> scene = model.source();
    return scene ? upload(model, *scene) : scene.error();
}

/// Of those that nothing needs and that can be read again; likewise pictures.
Model* Renderer::State::oldestModel() {
    Model* oldest = nullptr;
    for (const std::unique_ptr<Model>& model : models) {
        const bool needed =
            isShown(*model) || std::find(wanted.begin(), wanted.end(), model.get()) != wanted.end();
        if (model->gpu && model->source && !needed &&
            (oldest == nullptr || model->lastShown < oldest->lastShown))
            oldest = model.get();
    }
    return oldest;
}

Picture* Renderer::State::oldestPicture() {
    Picture* oldest = nullptr;
    for (Picture& picture : pictures)
        if (picture.texture.texture && picture.source && picture.lastDrawn < frameBegan &&
            (oldest == nullptr || picture.lastDrawn < oldest->lastDrawn))
            oldest = &picture;
    return oldest;
}

bool Renderer::State::evictOne() {
    Model* const model = oldestModel();
    Picture* const picture = oldestPicture();
    if (model == nullptr && picture == nullptr)
        return false;
    if (model == nullptr || (picture != nullptr && picture->lastDrawn < model->lastShown))
        picture->texture = {};
    else
        model->gpu.reset();
    glState.invalidate();
    return true;
}

void Renderer::State::addObjects(const GpuScene& scene) {
    std::vector<const Drawable*> sorted;
    for (const Drawable& drawable : scene.drawables)
        sorted.push_back(&drawable);
    std::stable_sort(sorted.begin(), sorted.end(), [](const Drawable* a, const Drawable* b) {
        return std::tie(a->material, a->mesh) < std::tie(b->material, b->mesh);
    });
    for (const Drawable* drawable : sorted)
        (drawable->blended ? blended : opaque)
            .push_back({.block = drawable->block,
                        .bounds = drawable->bounds,
                        .position = drawable->position,
                        .mesh = &scene.meshes[drawable->mesh],
                        .material = &scene.materials[drawable->material],
                        .order = static_cast<unsigned>(opaque.size()),
                        .mirrored = drawable->mirrored,
                        .doubleSided = drawable->doubleSided});
}

void Renderer::State::setShown(std::vector<Model*> list) {
    ++clock;
    for (Model* model : shown)
        model->lastShown = clock;
    shown = std::move(list);
    wanted.clear();
    opaque.clear();
    blended.clear();
    backToFront.clear();
    for (Model* model : shown) {
        model->lastShown = clock;
        addObjects(*model->gpu);
    }
    resolved = false;
}

Result<ModelId> Renderer::add(const Scene& scene, SceneSource source) {
    State& state = *m_state;
    auto model = std::make_unique<Model>(Model{ModelId{++state.lastId}, std::move(source)});
    if (Result<void> uploaded = state.upload(*model, scene); !uploaded)
        return uploaded.error();
    model->lastShown = state.clock;
    state.models.push_back(std::move(model));
    return state.models.back()->id;
}

Result<void> Renderer::show(std::span<const ModelId> ids) {
    State& state = *m_state;
    std::vector<Model*> list;
    for (const ModelId id : ids) {
        Model* const model = state.find(id);
        if (model == nullptr)
            return unknownModel();
        if (std::find(list.begin(), list.end(), model) == list.end())
            list.push_back(model);
    }
    const auto makeAll = [&]() -> Result<void> {
        for (Model* model : list)
            if (Result<void> made = state.makeResident(*model); !made)
                return made;
        return {};
    };
    std::vector<Model*> before = state.shown;
    state.wanted = list;
    Result<void> made = makeAll();
    if (!made && made.error().code == "memory.budget") {
        state.setShown({}); // What was shown may go now.
        state.wanted = list;
        made = makeAll();
    }
    if (!made)
        list = std::move(before);
    std::erase_if(list, [](const Model* model) { return !model->gpu; });
    state.setShown(std::move(list));
    return made;
}

void Renderer::remove(ModelId id) {
    State& state = *m_state;
    Model* const model = state.find(id);
    if (model == nullptr)
        return;
    if (state.isShown(*model)) {
        std::erase(state.shown, model);
        state.setShown(std::move(state.shown));
    }
    std::erase_if(state.models, [&](const std::unique_ptr<Model>& each) { return each.get() == model; });
    state.glState.invalidate();
}

Result<void> Renderer::load(const Scene& scene, SceneSource source) {
    State& state = *m_state;
    Result<ModelId> added = add(scene, source);
    if (!added && added.error().code == "memory.budget") {
        state.setShown({});
        state.models.clear();
        added = add(scene, std::move(source));
    }
    if (!added)
        return added.error();
    Model* const model = state.find(*added);
    state.setShown({model});
    std::erase_if(state.models, [&](const std::unique_ptr<Model>& each) { return each.get() != model; });
    state.glState.invalidate();
    return {};
}

} // namespace franken
