// SPDX-License-Identifier: MIT
#include "models.h"

#include "checked_upload.h"
#include "checks.h"
#include "franken/guard.h"
#include "franken/scene_check.h"
#include "handle.h"

#include <algorithm>

namespace franken {
namespace {

bool contains(const std::vector<Model*>& list, const Model& model) {
    return std::find(list.begin(), list.end(), &model) != list.end();
}

/// The caller's, for the time of a call.
std::shared_ptr<const Scene> unowned(const Scene& scene) { return {std::shared_ptr<void>(), &scene}; }

Error noSource() {
    return {"renderer.no-source", "", "the context of a model was lost, and it has no source",
            "pass add() a source that loads the model again"};
}

} // namespace

Models::Models(Device& device) : m_device(device), m_defaults(device.gl) {}

Model* Models::find(ModelId id) const {
    const auto found = std::find_if(m_models.begin(), m_models.end(),
                                    [&](const std::unique_ptr<Model>& model) { return model->id == id; });
    return found == m_models.end() ? nullptr : found->get();
}

bool Models::isNeeded(const Model& model) const {
    return contains(m_asked, model) || contains(m_wanted, model);
}

void Models::forgetOldNodes(Model& model) {
    for (Place* place : model.places)
        if (!check(model.outline.scene, place->pose))
            place->nodes.clear(); // The source reads another file now.
}

Result<void> Models::upload(Model& model, const Scene& scene) {
    model.outline = outlineOf(scene, model.changedMaterials);
    forgetOldNodes(model);
    Result<GpuScene> gpu = checkedUpload(m_device, [&] {
        return franken::upload(m_device, {unowned(scene), model.outline, m_device.capabilities, m_device.log},
                               *m_defaults);
    });
    if (!gpu)
        return gpu.error();
    model.gpu = *std::move(gpu);
    Result<void> changed = applyChanges(model);
    if (changed)
        model.scene.reset();
    else
        model.gpu.reset();
    return changed;
}

Result<void> Models::makeResident(Model& model) {
    if (model.gpu)
        return {};
    dequeue(model);
    m_ending.clear(); // A source is not called twice at a time.
    model.failure.reset();
    if (const std::shared_ptr<const Scene> scene = model.scene)
        return upload(model, *scene);
    if (!model.source)
        return noSource();
    const Result<Scene> scene = guarded("the source of a model", model.source);
    return scene ? upload(model, *scene) : scene.error();
}

Result<void> Models::makeResident(std::span<Model* const> models) {
    for (Model* model : models)
        if (Result<void> made = makeResident(*model); !made)
            return made;
    return {};
}

const Model* Models::oldest() const {
    const Model* oldest = nullptr;
    for (const std::unique_ptr<Model>& model : m_models)
        if (model->gpu && model->source && !isNeeded(*model) &&
            (oldest == nullptr || model->lastShown < oldest->lastShown))
            oldest = model.get();
    return oldest;
}

std::optional<std::uint64_t> Models::oldestUse() const {
    const Model* const model = oldest();
    return model == nullptr ? std::nullopt : std::optional(model->lastShown);
}

void Models::evictOldest() {
    if (const Model* const model = oldest())
        find(model->id)->gpu.reset();
}

void Models::setShown(std::vector<Model*> models) {
    ++m_device.clock;
    for (Model* model : m_shown)
        model->lastShown = m_device.clock;
    m_asked = std::move(models);
    m_shown = m_asked;
    std::erase_if(m_shown, [](const Model* model) { return !model->gpu; });
    for (Model* model : m_shown)
        model->lastShown = m_device.clock;
    m_wanted.clear();
    ++m_revision;
}

void Models::setAnisotropy(float anisotropy) {
    for (Model* model : m_shown) {
        if (model->gpu->anisotropy == anisotropy)
            continue;
        for (const GpuTexture& texture : model->gpu->textures)
            if (texture.texture && texture.hasMips)
                franken::setAnisotropy(m_device.gl, texture, anisotropy);
        model->gpu->anisotropy = anisotropy;
        m_device.state.invalidate();
    }
}

Result<ModelId> Models::add(const Scene& scene, SceneSource source) {
    auto model = std::make_unique<Model>(Model{newHandle<ModelId>(), std::move(source), {}, {}});
    if (Result<void> uploaded = upload(*model, scene); !uploaded)
        return uploaded.error();
    model->lastShown = m_device.clock;
    m_models.push_back(std::move(model));
    makePlace(*m_models.back(), glm::dmat4(1.0));
    return m_models.back()->id;
}

Result<void> Models::show(std::span<const ModelId> ids, Wait wait) {
    std::vector<Model*> list;
    for (const ModelId id : ids) {
        Model* const model = find(id);
        if (model == nullptr)
            return unknownModel();
        if (wait == Wait::No && !model->gpu && !model->scene && !model->source)
            return noSource();
        if (!contains(list, *model))
            list.push_back(model);
    }
    if (wait == Wait::Yes)
        return showResident(std::move(list));
    for (Model* model : list)
        if (!model->gpu)
            enqueue(*model);
    setShown(std::move(list));
    return {};
}

Result<void> Models::showResident(std::vector<Model*> list) {
    std::vector<Model*> before = m_asked;
    m_wanted = list;
    Result<void> made = makeResident(list);
    if (!made && (made.error().code == "memory.budget" || made.error().code == "renderer.memory")) {
        setShown({}); // What was shown may be evicted now.
        m_wanted = list;
        made = makeResident(list);
    }
    if (!made) {
        list = std::move(before);
        std::erase_if(list, [&](const Model* model) { return !model->gpu && !contains(m_queue, *model); });
    }
    setShown(std::move(list));
    return made;
}

void Models::remove(ModelId id) {
    Model* const model = find(id);
    if (model == nullptr)
        return;
    if (contains(m_asked, *model)) {
        std::vector<Model*> others = m_asked;
        std::erase(others, model);
        setShown(std::move(others));
    }
    erase(*model);
}

void Models::erase(Model& model) {
    dequeue(model);
    for (const Place* place : model.places)
        m_places.erase(PlaceId{place->id}); // A copy: the place holds the other.
    std::erase_if(m_models, [&](const std::unique_ptr<Model>& each) { return each.get() == &model; });
    m_device.state.invalidate();
}

void Models::eraseAllBut(const Model* kept) {
    for (const std::unique_ptr<Model>& each : m_models)
        if (each.get() != kept)
            dequeue(*each);
    std::erase_if(m_places, [&](const auto& place) { return place.second.model != kept; });
    std::erase_if(m_models, [&](const std::unique_ptr<Model>& each) { return each.get() != kept; });
    m_device.state.invalidate();
}

Result<void> Models::load(const Scene& scene, SceneSource source) {
    Result<ModelId> added = add(scene, source);
    if (!added && added.error().code == "memory.budget") {
        setShown({});
        eraseAllBut(nullptr);
        added = add(scene, std::move(source));
    }
    if (!added)
        return added.error();
    Model* const model = find(*added);
    setShown({model});
    eraseAllBut(model);
    return {};
}

void Models::lost() {
    cancelLoading(); // It begins again with the next context.
    for (const std::unique_ptr<Model>& model : m_models)
        model->gpu.reset();
    m_defaults.reset();
    ++m_revision;
}

Result<void> Models::restore() {
    m_defaults.emplace(m_device.gl);
    FirstError first;
    std::vector<Model*> list = m_asked;
    for (Model* model : list)
        if (!contains(m_queue, *model))
            first.add(makeResident(*model));
    std::erase_if(list, [&](const Model* model) { return !model->gpu && !contains(m_queue, *model); });
    setShown(std::move(list));
    return first.take();
}

} // namespace franken
