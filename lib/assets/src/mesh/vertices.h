// SPDX-License-Identifier: MIT
#pragma once

#include "franken/scene.h"

#include <cstdint>
#include <span>

/// What loading a file and completing a scene made by code both fill in.
namespace franken {

Box boundsOf(const std::vector<glm::vec3>& positions);

/// The vector in length 1, or `otherwise` where it has no length.
glm::vec3 unitOr(const glm::vec3& vector, const glm::vec3& otherwise);

/// Makes each vertex a copy of that one of the primitive; its joints and morph targets go along.
void gather(Primitive& primitive, std::span<const std::uint32_t> vertices);

/// The primitive's arrays that its deformation changes.
Vertices bindOf(const Primitive& primitive);

/// Notes what the primitive's vertices are before its deformation moves them, and measures that. Everything
/// in the deformation must be in range.
void bind(Primitive& primitive);

/// Tangents for that normal texture, where there are none. False where the texture's coordinates are missing.
bool fillTangents(Primitive& primitive, const TextureRef& normalTexture);

} // namespace franken
