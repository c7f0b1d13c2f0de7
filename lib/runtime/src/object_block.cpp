// SPDX-License-Identifier: MIT
#include "object_block.h"

namespace franken {
namespace {

/// The inverse transpose up to a factor; a matrix that squashes to a plane has one as well.
glm::dmat3 cofactors(const glm::dmat3& m) {
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

} // namespace

Float3 toFloat3(const glm::dvec3& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

void placeObject(ObjectBlock& block, const glm::dmat4& world, bool mirrored) {
    roundTo(block.model, world);
    roundTo(block.normalMatrix, (mirrored ? -1.0 : 1.0) * cofactors(glm::dmat3(world)));
}

void projectObject(ObjectBlock& block, const glm::dmat4& viewProjection, const glm::dmat4& world) {
    glm::dmat4 product; // The last row of `world` is known.
    for (int column = 0; column < 4; ++column)
        product[column] = viewProjection[0] * world[column].x + viewProjection[1] * world[column].y +
                          viewProjection[2] * world[column].z;
    product[3] += viewProjection[3];
    roundTo(block.modelViewProjection, product);
}

} // namespace franken
