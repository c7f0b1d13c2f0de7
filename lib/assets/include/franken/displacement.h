// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/image.h"
#include "franken/result.h"
#include "franken/scene.h"

#include <span>

namespace FRANKEN_API franken {

/// Heights over a surface, as a picture: R, linear and never decoded. A Pi's vertex shaders read textures
/// slowly or not at all, so heights move the vertices once, when a model is loaded. The mesh gets no finer:
/// heights between two vertices are lost. Eight bits are 256 steps; on a mesh with more vertices than texels,
/// slopes are those between texels.
struct HeightMap {
    Image image;      ///< The heights; one channel is enough.
    float scale = 1;  ///< How far white (1) lies above black (0), in the unit of the positions; any sign.
    float ground = 0; ///< 0-1: vertices of this height do not move.
    int uvSet = 0;    ///< 0 or 1: TEXCOORD_n, v down.
    /// What lies outside of 0-1, across and down.
    Wrap wrapS = Wrap::Repeat;
    Wrap wrapT = Wrap::Repeat;
};

/// The height at a point, 0-1, interpolated between the four nearest texels as GL's linear filter does
/// (OpenGL ES 2.0, 3.7.7). The image must not be empty.
float heightAt(const HeightMap& map, const glm::vec2& uv);

/// Moves each vertex along its normal by scale * (height - ground), and recomputes normals, tangents and
/// bounds.
///
/// Vertices that share a position move as one, by the mean height along the mean of their normals, so that no
/// crack opens at seams and hard edges. Vertices that also shared a normal share the new one: the sum of
/// their triangles' normals, weighted by the angle at the vertex (Thürmer and Wüthrich, "Computing Vertex
/// Normals from Polygonal Facets", 1998). Hard edges stay hard; a vertex all of whose triangles have lost
/// their area keeps its normal. If the primitive has tangents, computeTangents() recomputes them with
/// `tangentUv`, which is needed only then.
///
/// What a skin or a morph moves is displaced as it is before they move it, and comes out like that.
///
/// Fails with "height.image" for an empty image, and with "height.uv" where the primitive lacks the UV
/// stream.
Result<void> displace(Primitive& primitive, const HeightMap& map, std::span<const glm::vec2> tangentUv = {});

/// Displaces all primitives with that material, or all of the scene (kNone). Where one of them has a skin or
/// a morph, the scene comes out in its rest pose. Fails as the function above
/// does; then some may be displaced and others not.
Result<void> displace(Scene& scene, const HeightMap& map, int material = kNone);

} // namespace franken
