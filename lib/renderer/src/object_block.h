// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/pack.h"

#include <glm/ext/matrix_double4x4.hpp>
#include <glm/ext/vector_double3.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace franken {

/// Matrices are computed in double and rounded to float only here.
template<typename Values, typename Matrix>
void roundTo(Values& values, const Matrix& matrix) {
    std::transform(glm::value_ptr(matrix), glm::value_ptr(matrix) + values.size(), values.begin(),
                   [](double value) { return static_cast<float>(value); });
}

Float3 toFloat3(const glm::dvec3& v);

/// What depends on where an object is: its model and normal matrices. `world` is affine.
void placeObject(ObjectBlock& block, const glm::mat4& world, bool mirrored);

/// What depends on the camera as well; after placeObject().
void projectObject(ObjectBlock& block, const glm::dmat4& viewProjection);

} // namespace franken
