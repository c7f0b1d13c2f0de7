// SPDX-License-Identifier: MIT
// What a ray meets of the models that are shown.
#include "checks.h"
#include "models.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

namespace franken {
namespace {

/// The ray as it is in the space of the scene that stands at the place; an error where the place is flat.
Result<Ray> inScene(const Ray& ray, const glm::dmat4& world) {
    const glm::dmat3 inverse = glm::inverse(glm::dmat3(world));
    const glm::dvec3 direction = inverse * ray.direction;
    return normalized({.origin = inverse * (ray.origin - glm::dvec3(world[3])),
                       .direction = direction,
                       .length = ray.length * glm::length(direction)});
}

} // namespace

Result<void> Models::setPickTree(ModelId id, std::optional<PickTree> tree) {
    Model* const model = find(id);
    if (model == nullptr)
        return unknownModel();
    const Scene& scene = model->outline.scene;
    const PickTree::Counts expected{tree ? tree->counts().triangles : 0, model->outline.nodes.size(),
                                    scene.materials.size(), scene.variants.size(), scene.nodes.size()};
    if (tree && tree->counts() != expected)
        return Error{"renderer.tree", "", "the tree is that of another scene",
                     "pass PickTree::of() of the scene that add() got"};
    model->pickTree = std::move(tree);
    return {};
}

Result<std::optional<PlaceHit>> Models::pick(const Ray& given) const {
    const Result<Ray> ray = normalized(given);
    if (!ray)
        return ray.error();
    std::optional<PlaceHit> nearest;
    Ray rest = *ray; // Up to the nearest surface.
    const auto test = [&](const Model& model, const Place& place) -> Result<void> {
        const Result<Ray> local = inScene(rest, place.world);
        if (!local)
            return {};
        const bool posed = !place.nodes.empty();
        const Result<std::optional<Hit>> hit =
            model.pickTree->pick(*local, {.variant = place.variant,
                                          .materials = model.outline.scene.materials,
                                          .pose = posed ? &place.pose : nullptr,
                                          .nodes = posed ? &place.nodes : nullptr});
        if (!hit)
            return hit.error();
        if (!*hit)
            return {};
        nearest = PlaceHit{**hit, model.id, place.id};
        nearest->point = glm::dvec3(place.world * glm::dvec4((*hit)->point, 1));
        nearest->distance = std::max(0.0, glm::dot(nearest->point - ray->origin, ray->direction));
        rest.length = nearest->distance;
        return {};
    };
    for (const Model* model : m_shown)
        for (const Place* place : model->places)
            if (model->pickTree && place->visible && rest.length > 0)
                if (Result<void> tested = test(*model, *place); !tested)
                    return tested.error();
    return nearest;
}

} // namespace franken
