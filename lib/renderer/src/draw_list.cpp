// SPDX-License-Identifier: MIT
#include "draw_list.h"

#include "object_block.h"

#include <algorithm>
#include <tuple>

namespace franken {
namespace {

/// Whether the object is visible; a visible one is placed, with the next serial.
bool placeOne(Object& object, const Frustum& frustum, const Viewpoint& viewpoint, std::uint64_t& nextSerial) {
    object.visible = object.material->program && frustum.mayShow(object.bounds);
    if (object.visible) {
        projectObject(object.block, object.position, viewpoint);
        object.serial = nextSerial++;
    }
    return object.visible;
}

} // namespace

void DrawList::rebuild(const std::vector<Model*>& shown) {
    m_opaque.clear();
    m_blended.clear();
    m_backToFront.clear();
    m_placedFor.reset();
    m_visible = 0;
    for (const Model* model : shown)
        add(*model->gpu);
}

void DrawList::add(const GpuScene& scene) {
    std::vector<const Drawable*> sorted;
    for (const Drawable& drawable : scene.drawables)
        sorted.push_back(&drawable);
    std::stable_sort(sorted.begin(), sorted.end(), [](const Drawable* a, const Drawable* b) {
        return std::tie(a->material, a->mesh) < std::tie(b->material, b->mesh);
    });
    for (const Drawable* drawable : sorted)
        (drawable->blended ? m_blended : m_opaque)
            .push_back({.block = drawable->block,
                        .bounds = drawable->bounds,
                        .position = drawable->position,
                        .mesh = &scene.meshes[drawable->mesh],
                        .material = &scene.materials[drawable->material],
                        .order = static_cast<unsigned>(m_opaque.size()),
                        .mirrored = drawable->mirrored,
                        .doubleSided = drawable->doubleSided});
}

void DrawList::sort() {
    const auto order = [](const Object& object) {
        const ProgramHandle& program = object.material->program;
        const bool samples = program && !program->interface().samplers.empty();
        return std::tuple(samples, program ? program->name() : 0, object.order);
    };
    std::sort(m_opaque.begin(), m_opaque.end(),
              [&](const Object& a, const Object& b) { return order(a) < order(b); });
    m_placedFor.reset();
}

void DrawList::place(const Viewpoint& viewpoint) {
    if (m_placedFor == viewpoint)
        return;
    const Frustum frustum(viewpoint.viewProjection);
    std::uint64_t serial = newSerials(size());
    m_visible = 0;
    for (Object& object : m_opaque)
        m_visible += placeOne(object, frustum, viewpoint, serial) ? 1 : 0;
    m_backToFront.clear();
    for (Object& object : m_blended)
        if (placeOne(object, frustum, viewpoint, serial))
            m_backToFront.push_back(&object);
    m_visible += m_backToFront.size();
    const auto depth = [&](const Object* object) {
        return glm::dot(object->bounds.center - viewpoint.eye, viewpoint.forward);
    };
    std::stable_sort(m_backToFront.begin(), m_backToFront.end(),
                     [&](const Object* a, const Object* b) { return depth(a) > depth(b); });
    m_placedFor = viewpoint;
}

double DrawList::farthest(const glm::dvec3& eye) const {
    double farthest = 0;
    for (const std::vector<Object>* objects : {&m_opaque, &m_blended})
        for (const Object& object : *objects)
            if (object.visible)
                farthest = std::max(farthest, glm::length(object.bounds.center - eye) +
                                                  glm::length(object.bounds.extent));
    return farthest;
}

} // namespace franken
