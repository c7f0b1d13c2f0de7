// SPDX-License-Identifier: MIT
#include "franken/scene.h"

#include <glm/common.hpp>

namespace franken {

void Box::add(const glm::dvec3& point) {
    min = glm::min(min, point);
    max = glm::max(max, point);
}

void Box::add(const Box& box, const glm::dmat4& world) {
    if (box.empty())
        return;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 point((corner & 1) ? box.max.x : box.min.x, (corner & 2) ? box.max.y : box.min.y,
                               (corner & 4) ? box.max.z : box.min.z);
        add(glm::dvec3(world * glm::dvec4(point, 1.0)));
    }
}

Box Scene::bounds() const {
    Box bounds;
    for (const Instance& instance : instances) {
        if (!instance.visible)
            continue;
        for (const Primitive& primitive : meshes[static_cast<std::size_t>(instance.mesh)].primitives)
            bounds.add(primitive.bounds, instance.world);
    }
    return bounds;
}

} // namespace franken
