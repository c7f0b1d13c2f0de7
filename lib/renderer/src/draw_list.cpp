// SPDX-License-Identifier: MIT
#include "draw_list.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace franken {
namespace {

/// Where a pose has the drawable's node; null where nothing poses it.
const NodeWorld* nodeOf(const Place& place, const Drawable& drawable) {
    return place.nodes.empty() || drawable.nodeIndex == kNone
               ? nullptr
               : &place.nodes[static_cast<std::size_t>(drawable.nodeIndex)];
}

bool isVisible(const Place& place, const Drawable& drawable) {
    const NodeWorld* const node = nodeOf(place, drawable);
    return place.visible && (node == nullptr ? drawable.visible : node->visible);
}

void updatePalette(Object& object) {
    const Outline& outline = object.place->model->outline;
    const std::vector<NodeWorld>& posed = object.place->nodes;
    paletteOf(outline.scene.skins[static_cast<std::size_t>(object.drawable->skin)],
              posed.empty() ? outline.rest : posed, object.palette);
}

/// From the object to where the model stands. A skin's joints stand in for the node.
glm::dmat4 worldOf(const Object& object, const NodeWorld* node) {
    const Drawable& drawable = *object.drawable;
    if (node == nullptr)
        return drawable.world;
    return drawable.skin == kNone ? node->matrix * drawable.offset
                                  : glm::translate(glm::dmat4(1.0), object.palette.origin);
}

/// What follows from where the object stands, whatever the camera. The node says how a skinned mesh winds,
/// whose normals its joints have turned already.
void settle(Object& object, const glm::dmat3& skyFromWorld) {
    const Drawable& drawable = *object.drawable;
    const NodeWorld* const node = nodeOf(*object.place, drawable);
    if (drawable.skin != kNone)
        updatePalette(object);
    if (object.mesh->isSkinned())
        object.paletteSerial = newSerials(object.mesh->parts());
    const glm::dmat4 world = object.place->world * worldOf(object, node);
    const bool isMirrored = node == nullptr
                                ? drawable.mirrored
                                : glm::determinant(glm::dmat3(node->matrix * drawable.offset)) < 0;
    const bool isTurnedInsideOut = glm::determinant(glm::dmat3(object.place->world)) < 0;
    object.mirrored = isMirrored != isTurnedInsideOut;
    const bool moves = object.mesh->isSkinned() || isPosed(object);
    object.bounds = boundsOf(moves ? boundsOf(*object.primitive->deformation, deformingOf(object))
                                   : object.primitive->bounds,
                             world);
    object.position = glm::dvec3(world[3]);
    placeObject(object.block, world, drawable.skin == kNone ? object.mirrored : isTurnedInsideOut,
                skyFromWorld);
    object.movements = object.place->movements;
    object.isPlaced = true;
}

} // namespace

bool isSkinnedByProgram(const Object& object) {
    static const int kJointsLocation = attributeLocation("aJoints");
    return object.mesh->isSkinned() && (object.material->program->attributes() >> kJointsLocation & 1U) != 0;
}

Deforming deformingOf(const Object& object) {
    const Place& place = *object.place;
    const Drawable& drawable = *object.drawable;
    const NodeWorld* const node = nodeOf(place, drawable);
    Deforming deforming{.joints = object.palette.joints,
                        .mirrored = node == nullptr
                                        ? drawable.mirrored
                                        : glm::determinant(glm::dmat3(node->matrix * drawable.offset)) < 0};
    if (drawable.nodeIndex != kNone) {
        const auto index = static_cast<std::size_t>(drawable.nodeIndex);
        deforming.weights = node == nullptr ? place.model->outline.scene.nodes[index].rest.weights
                                            : place.pose.nodes[index].weights;
    }
    return deforming;
}

void DrawList::rebuild(const std::vector<Model*>& shown) {
    m_opaque.clear();
    m_blended.clear();
    m_backToFront.clear();
    m_frontToBack.clear();
    m_materials.clear();
    m_placedFor.reset();
    m_visible = 0;
    m_canDeform = false;
    for (Model* model : shown)
        add(*model);
    m_backToFront.reserve(m_blended.size());
    m_frontToBack.reserve(m_opaque.size());
    for (const std::vector<Object>* objects : {&m_opaque, &m_blended})
        for (const Object& object : *objects)
            m_materials.push_back(object.material);
    std::sort(m_materials.begin(), m_materials.end());
    m_materials.erase(std::unique(m_materials.begin(), m_materials.end()), m_materials.end());
}

void DrawList::add(Model& model) {
    GpuScene& scene = *model.gpu;
    struct Draw {
        std::size_t material, mesh;
        const Place* place;
        const Drawable* drawable;
    };
    std::vector<Draw> draws;
    for (const Place* place : model.places)
        for (const Drawable& drawable : scene.drawables) {
            const GpuPrimitive& primitive = scene.primitives[drawable.primitive];
            m_canDeform = m_canDeform || primitive.deformation;
            draws.push_back({primitive.materialIn(place->variant), primitive.mesh, place, &drawable});
        }
    std::stable_sort(draws.begin(), draws.end(), [](const Draw& a, const Draw& b) {
        return std::tie(a.material, a.mesh) < std::tie(b.material, b.mesh);
    });
    for (const Draw& draw : draws)
        (scene.materials[draw.material].blended ? m_blended : m_opaque)
            .push_back({.place = draw.place,
                        .drawable = draw.drawable,
                        .primitive = &scene.primitives[draw.drawable->primitive],
                        .mesh = &scene.meshes[draw.mesh],
                        .material = &scene.materials[draw.material],
                        .order = static_cast<unsigned>(m_opaque.size())});
}

// What is discarded leaves no depth early: masked surfaces come after all that can hide them.
void DrawList::sort() {
    const auto groupOf = [](const Object& object) {
        const ProgramHandle& program = object.material->program;
        const bool samples = program && !program->interface().samplers.empty();
        const bool masked = object.material->plan.permutation.alpha == Alpha::Mask;
        return std::tuple(masked, samples, program ? program->name() : 0);
    };
    std::sort(m_opaque.begin(), m_opaque.end(), [&](const Object& a, const Object& b) {
        return std::pair(groupOf(a), a.order) < std::pair(groupOf(b), b.order);
    });
    for (std::size_t i = 1; i < m_opaque.size(); ++i)
        m_opaque[i].group =
            m_opaque[i - 1].group + (groupOf(m_opaque[i - 1]) != groupOf(m_opaque[i]) ? 1 : 0);
    m_placedFor.reset();
}

// Few slices, so that most objects of a material still follow each other; none thinner than what rounding
// makes of objects that are as deep.
void DrawList::sortFrontToBack(const Viewpoint& viewpoint) {
    constexpr double kSlices = 16;
    const auto depthOf = [&](const Object& object) {
        return glm::dot(object.bounds.center - viewpoint.eye, viewpoint.forward);
    };
    double nearest = std::numeric_limits<double>::max(), farthest = -nearest;
    for (const Layer& layer : m_frontToBack) {
        nearest = std::min(nearest, depthOf(*layer.object));
        farthest = std::max(farthest, depthOf(*layer.object));
    }
    const double thinnest = 1e-4 * std::max(std::abs(nearest), std::abs(farthest));
    const double scale = farthest - nearest > thinnest ? (kSlices - 1) / (farthest - nearest) : 0;
    for (Layer& layer : m_frontToBack)
        layer.slice = static_cast<int>((depthOf(*layer.object) - nearest) * scale + 0.5);
    std::sort(m_frontToBack.begin(), m_frontToBack.end(), [](const Layer& a, const Layer& b) {
        return std::tie(a.object->group, a.slice, a.object) < std::tie(b.object->group, b.slice, b.object);
    });
}

/// Whether the object is visible; a visible one is placed, with the next serial.
bool DrawList::placeOne(Object& object, const Frustum& frustum, const glm::dmat4& skyToClip) {
    const Place& place = *object.place;
    object.visible = isVisible(place, *object.drawable) && object.material->program;
    if (!object.visible)
        return false;
    if (!object.isPlaced || object.movements != place.movements)
        settle(object, m_placedFor->skyFromWorld);
    object.visible = frustum.mayShow(object.bounds);
    if (object.visible) {
        projectObject(object.block, object.position, *m_placedFor, skyToClip);
        object.serial = m_nextSerial++;
    }
    return object.visible;
}

void DrawList::place(const PlacedView& view, unsigned movements) {
    if (m_placedFor == view && m_movements == movements)
        return;
    if (!m_placedFor || m_placedFor->skyFromWorld != view.skyFromWorld)
        for (std::vector<Object>* objects : {&m_opaque, &m_blended})
            for (Object& object : *objects)
                object.isPlaced = false;
    m_placedFor = view;
    m_movements = movements;
    const Viewpoint& viewpoint = view.viewpoint;
    const Frustum frustum(viewpoint.viewProjection);
    const glm::dmat4 skyToClip = viewpoint.viewProjection * glm::dmat4(glm::transpose(view.skyFromWorld));
    m_nextSerial = newSerials(size());
    m_frontToBack.clear();
    for (Object& object : m_opaque)
        if (placeOne(object, frustum, skyToClip))
            m_frontToBack.push_back({&object, 0});
    sortFrontToBack(viewpoint);
    m_backToFront.clear();
    for (Object& object : m_blended)
        if (placeOne(object, frustum, skyToClip))
            m_backToFront.push_back(&object);
    m_visible = m_frontToBack.size() + m_backToFront.size();
    const auto nearness = [&](const Object* object) { // Objects as deep keep their order: no sort is stable
        return std::pair(-glm::dot(object->bounds.center - viewpoint.eye, viewpoint.forward), object);
    }; // without allocating.
    std::sort(m_backToFront.begin(), m_backToFront.end(),
              [&](const Object* a, const Object* b) { return nearness(a) < nearness(b); });
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
