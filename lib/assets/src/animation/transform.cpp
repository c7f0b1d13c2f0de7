// SPDX-License-Identifier: MIT
#include "franken/animation.h"

#include "animation/rotation.h"

namespace franken {

glm::dmat4 matrixOf(const Transform& transform) {
    glm::dmat4 matrix = glm::mat4_cast(unit(transform.rotation));
    for (int axis = 0; axis < 3; ++axis)
        matrix[axis] *= transform.scale[axis];
    matrix[3] = glm::dvec4(transform.translation, 1.0);
    return matrix;
}

std::size_t widthOf(AnimationChannel::Path path, std::size_t weights) {
    switch (path) {
    case AnimationChannel::Path::Rotation:
        return 4;
    case AnimationChannel::Path::Weights:
        return weights;
    case AnimationChannel::Path::Visible:
        return 1;
    default:
        return 3;
    }
}

} // namespace franken
