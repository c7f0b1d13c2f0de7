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

void placeObject(ObjectBlock& block, const glm::mat4& world, bool mirrored) {
    std::copy_n(glm::value_ptr(world), block.model.size(), block.model.begin());
    roundTo(block.normalMatrix, (mirrored ? -1.0 : 1.0) * cofactors(glm::dmat3(world)));
}

void projectObject(ObjectBlock& block, const glm::dmat4& viewProjection) {
    const double* const camera = glm::value_ptr(viewProjection);
    for (std::size_t column = 0; column < 4; ++column) {
        const float* const model = block.model.data() + 4 * column;
        const double last = column == 3 ? 1 : 0; // The matrix is affine.
        for (std::size_t row = 0; row < 4; ++row)
            block.modelViewProjection[4 * column + row] =
                static_cast<float>(camera[row] * model[0] + camera[4 + row] * model[1] +
                                   camera[8 + row] * model[2] + camera[12 + row] * last);
    }
}

} // namespace franken
