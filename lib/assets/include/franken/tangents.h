// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "franken/api.h"
#include "franken/scene.h"

namespace FRANKEN_API franken {

/// Gives every triangle its own three vertices, with the triangle's own normal, as glTF 2.0 (3.7.2.1) demands
/// for files without normals. The file's tangents are dropped, as the same section demands; other attributes
/// are kept. The normal of a triangle without area is +Z. Needs `positions` and `indices`.
void computeFlatNormals(Primitive& primitive);

/// Gives every vertex the mean of the normals of all triangles that have a corner at its position, each
/// weighted by its angle there (G. Thürmer and C. Wüthrich, "Computing Vertex Normals from Polygonal Facets",
/// 1998). Vertices of equal position get equal normals, so that seams of texture coordinates are not seen;
/// nothing is added or moved. Triangles must be wound alike. Tangents are dropped. +Z where triangles have no
/// area, cancel each other, or are none. Needs `positions` and `indices`. Computes in double.
void computeSmoothNormals(Primitive& primitive);

/// Computes `tangents` by the method of MikkTSpace (M. Mikkelsen, "Simulation of Wrinkled Surfaces
/// Revisited", 2008, and the reference code's documentation), which is what normal maps are baked against:
///
/// - vertices with equal position, normal and UV are one, whatever the indices say;
/// - around such a vertex, triangles that are joined by edges and have the same UV orientation form a group;
///   mirrored UVs never share one;
/// - the tangent of a group is the mean of its triangles' dP/du, each projected on the vertex's plane,
///   normalised, and weighted by the triangle's angle at the vertex (also measured in that plane);
/// - triangles without area take the tangent of a neighbour; a vertex for which nothing is known gets any
///   unit vector in its plane.
///
/// Where a vertex is in several groups, copies of it are appended. w is such that cross(N, T) * w points
/// towards smaller v, which is up in the image: glTF's v grows downwards. (The reference code's splitting of
/// a group by an angular threshold is left out: at its default of 180 degrees it does nothing.)
///
/// `uv` has the normal map's texture coordinates, one for each vertex: the primitive's stream, after its
/// KHR_texture_transform if it has one. Needs `positions`, `normals` and `indices`. Computes in float.
void computeTangents(Primitive& primitive, std::span<const glm::vec2> uv);

/// The coordinates of a texture of the primitive's material: its stream, after its KHR_texture_transform.
/// Empty where the primitive lacks the stream.
std::vector<glm::vec2> sampledUv(const Primitive& primitive, const TextureRef& texture);

} // namespace franken
