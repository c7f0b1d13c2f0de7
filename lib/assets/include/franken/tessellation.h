// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/scene.h"

namespace FRANKEN_API franken {

/// How finely a mesh is tessellated, as light sees it: the angle by which normals turn within a triangle, in
/// radians, such that triangles with more than it hold at most 1 % of the surface. 0 for a flat or empty
/// mesh. Hard edges have their normals apart in different vertices and so do not count.
float normalTurn(const Primitive& primitive);

/// Up to this turn, light vectors per vertex give the picture that those per pixel give: 8 degrees, the
/// diagonal of a sphere's quads at 64 by 32, on which 0.5 % of the pixels or fewer differ by more than one
/// code (tests/render/light_vectors_test.cpp).
inline constexpr float kFineNormalTurn = 0.14f;

} // namespace franken
