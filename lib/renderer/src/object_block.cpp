// SPDX-License-Identifier: MIT
#include "object_block.h"

namespace franken {
namespace {

/// The inverse transpose up to a factor; a matrix that squashes to a plane has one as well.
glm::dmat3 cofactors(const glm::dmat3& m) {
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

} // namespace

void placeObject(ObjectBlock& block, const glm::dmat4& world, bool mirrored, const glm::dmat3& skyFromWorld) {
    const glm::dmat3 model = skyFromWorld * glm::dmat3(world);
    roundTo(block.model, glm::dmat4(model));
    roundTo(block.normalMatrix, (mirrored ? -1.0 : 1.0) * cofactors(model));
}

void projectObject(ObjectBlock& block, const glm::dvec3& position, const PlacedView& view,
                   const glm::dmat4& skyToClip) {
    const double* const toClip = glm::value_ptr(skyToClip);
    for (std::size_t column = 0; column < 3; ++column) {
        const float* const model = block.model.data() + 4 * column;
        for (std::size_t row = 0; row < 4; ++row)
            block.modelViewProjection[4 * column + row] = static_cast<float>(
                toClip[row] * model[0] + toClip[4 + row] * model[1] + toClip[8 + row] * model[2]);
    }
    const double* const camera = glm::value_ptr(view.viewpoint.viewProjection);
    for (std::size_t row = 0; row < 4; ++row)
        block.modelViewProjection[12 + row] =
            static_cast<float>(camera[row] * position.x + camera[4 + row] * position.y +
                               camera[8 + row] * position.z + camera[12 + row]);
    const glm::dvec3 fromEye = view.skyFromWorld * (position - view.viewpoint.eye);
    for (int axis = 0; axis < 3; ++axis)
        block.model[static_cast<std::size_t>(12 + axis)] = static_cast<float>(fromEye[axis]);
}

} // namespace franken
