// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/permutation.h"

#include <glm/ext/vector_double3.hpp>

namespace franken::test {

/// A point that one sun lights: irradiance pi on a surface that faces it, so that a white Lambert surface is
/// 1. All vectors unit, away from the surface.
struct LitPoint {
    glm::dvec3 normal{0, 0, 1};
    glm::dvec3 toCamera{0, 0, 1};
    glm::dvec3 toLight{0, 0, 1};
    glm::dvec3 baseColor{1, 1, 1};
    double metallic = 0;
    double roughness = 1;
};

/// The radiance that leaves it, in double precision and as its papers print it: with H, with square roots
/// where they stand, with nothing folded. It is what the snippets are held against.
glm::dvec3 radianceOf(const LitPoint& point, Brdf brdf);

} // namespace franken::test
