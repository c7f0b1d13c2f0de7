// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/result.h"
#include "franken/scene.h"

/// Scenes that are made by code instead of loaded: what a file leaves to a loader, and simple shapes.
namespace FRANKEN_API franken {

/// How normals are made that a scene leaves out.
enum class Normals {
    Flat,   ///< Each triangle has its own, as glTF 2.0 (3.7.2.1) says: computeFlatNormals().
    Smooth, ///< Triangles that meet in a point share one: computeSmoothNormals().
};

/// Fills in what a scene made by code leaves out, as loadGltf() does for a file:
///
/// - a material, glTF's default one, for primitives whose material is kNone, or where there are no materials;
/// - indices 0, 1, 2, …, where there are none;
/// - normals, where there are none, flat or smooth; others are made unit length;
/// - winding: a triangle all of whose normals point to its back is turned round, and Instance::mirrored is
///   set by its matrix;
/// - tangents, where the material or that of a variant has a normal texture (the first one counts: a vertex
///   has one tangent), its texture coordinates are there, and tangents are not: computeTangents();
/// - bounds, always;
/// - Deformation::bind, where a primitive has a deformation without it: its arrays as they are before that
///   moves them. The scene comes out in its rest pose then.
///
/// The result passes check(scene). A primitive needs only positions; a scene still needs an instance for each
/// mesh that is to be seen. Costs a few passes over all vertices, and computeTangents(). Fails with
/// "scene.data", which names the element that is wrong: what cannot be filled in, and what is there but
/// wrong. To keep the scene where that may be, pass a copy. Safe on any thread.
Result<Scene> complete(Scene scene, Normals normals = Normals::Flat);

/// A rectangle in the plane z = 0 round the origin that faces +Z, of that width and height in metres, with
/// normals, tangents and texture coordinates from the upper left corner. 2 triangles.
Primitive plane(const glm::vec2& size);

/// A box round the origin with edges of that length in metres; each face has normals, tangents and all of the
/// texture, upright on the four sides. 12 triangles. Signs of sizes are ignored.
Primitive box(const glm::vec3& size);

/// A sphere round the origin, of that radius in metres, with normals, tangents and texture coordinates: u
/// from +Z eastwards (over +X), v from the north pole (+Y) down. Of 2 * rings by rings quads; fewer than 2
/// rings are 2, and more than 1024 are 1024. The sign of the radius is ignored.
Primitive sphere(float radius, int rings);

} // namespace franken
