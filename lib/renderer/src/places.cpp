// SPDX-License-Identifier: MIT
// Where models stand.
#include "checks.h"
#include "handle.h"
#include "models.h"

#include <algorithm>

namespace franken {

const Place* Models::find(PlaceId id) const {
    const auto found = m_places.find(id);
    return found == m_places.end() ? nullptr : &found->second;
}

Place& Models::makePlace(Model& model, const glm::dmat4& world) {
    const auto id = newHandle<PlaceId>();
    Place& place = m_places.emplace(id, Place{.id = id, .model = &model, .world = world}).first->second;
    model.places.push_back(&place);
    notePlaces(model);
    return place;
}

Result<PlaceId> Models::addPlace(ModelId id, const glm::dmat4& world) {
    Model* const model = find(id);
    if (model == nullptr)
        return unknownModel();
    if (Result<void> checked = checkTransform(world); !checked)
        return checked.error();
    return makePlace(*model, world).id;
}

Result<PlaceId> Models::firstPlace(ModelId id) const {
    const Model* const model = find(id);
    if (model == nullptr)
        return unknownModel();
    if (model->places.empty())
        return unknownPlace();
    return model->places.front()->id;
}

void Models::removePlace(PlaceId id) {
    Place* const place = find(id);
    if (place == nullptr)
        return;
    Model& model = *place->model;
    const auto isOfPlace = [id](const auto& posed) { return posed.first.first == id; };
    if (model.gpu && std::erase_if(model.gpu->posed, isOfPlace) > 0)
        m_device.state.invalidate();
    std::erase(model.places, place);
    m_places.erase(id);
    notePlaces(model);
}

void Models::notePlaces(const Model& model) {
    if (std::find(m_shown.begin(), m_shown.end(), &model) != m_shown.end())
        ++m_revision;
}

void Models::noteMovement(Place& place) {
    ++place.movements;
    ++m_movements;
}

Result<void> Models::setWorld(PlaceId id, const glm::dmat4& world) {
    Place* const place = find(id);
    if (place == nullptr)
        return unknownPlace();
    if (Result<void> checked = checkTransform(world); !checked)
        return checked;
    if (place->world == world)
        return {};
    place->world = world;
    noteMovement(*place);
    return {};
}

Result<void> Models::setPose(PlaceId id, const Pose& pose) {
    Place* const place = find(id);
    if (place == nullptr)
        return unknownPlace();
    const Scene& outline = place->model->outline.scene;
    if (Result<void> checked = check(outline, pose); !checked)
        return checked;
    if (!place->nodes.empty() && place->pose == pose)
        return {};
    place->pose = pose;
    ++place->poses;
    worldsOf(outline, place->pose, place->nodes);
    noteMovement(*place);
    return {};
}

Result<void> Models::setVisible(PlaceId id, bool visible) {
    Place* const place = find(id);
    if (place == nullptr)
        return unknownPlace();
    if (place->visible == visible)
        return {};
    place->visible = visible;
    ++m_movements;
    return {};
}

Result<void> Models::setEffectValues(PlaceId id, std::span<const Float4> values) {
    Place* const place = find(id);
    if (place == nullptr)
        return unknownPlace();
    const Result<EffectBlock> block = effectBlock(values);
    if (!block)
        return block.error();
    if (values.empty())
        place->effect.reset();
    else if (place->effect)
        place->effect->set(*block);
    else
        place->effect.emplace().edit() = *block;
    return {};
}

} // namespace franken
