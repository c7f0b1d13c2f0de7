// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/scene.h"

namespace FRANKEN_API franken {

/// How finely a mesh is tessellated, as light sees it: the angle between the vertex normals of a triangle, in
/// radians, 99th percentile by area. 0 for a flat or empty mesh. A hard edge does not count: its two sides
/// have vertices of their own.
float normalTurn(const Primitive& primitive);

/// Up to this angle, light vectors per vertex draw the same picture as light vectors per pixel. 8 degrees is
/// the diagonal of a quad of a sphere of 64 by 32, where at most 0.5 % of the pixels differ by more than one
/// code (tests/renderer/light_vectors_test.cpp).
inline constexpr float kFineNormalTurn = 0.14f;

} // namespace franken
