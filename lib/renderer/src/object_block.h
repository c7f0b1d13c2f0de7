// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/pack.h"
#include "franken/viewpoint.h"

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

/// What depends on the object and the sky's rotation alone: the normal matrix, and the model matrix but for
/// the translation, both into the space that programs compute in. `world` is affine.
void placeObject(ObjectBlock& block, const glm::dmat4& world, bool mirrored, const glm::dmat3& skyFromWorld);

/// A camera, and the sky's rotation: what all objects of a frame are placed for.
struct PlacedView {
    Viewpoint viewpoint;
    glm::dmat3 skyFromWorld{1.0};
    friend bool operator==(const PlacedView&, const PlacedView&) = default;
};

/// What depends on the camera as well; after placeObject(). `position` is the translation of its world
/// matrix; `skyToClip` is without its translation. The model matrix leads from the object to the sky as seen
/// from the eye: a float has 24 bits, which far from the origin would be spent on the way there.
void projectObject(ObjectBlock& block, const glm::dvec3& position, const PlacedView& view,
                   const glm::dmat4& skyToClip);

} // namespace franken
