// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/result.h"
#include "franken/scene.h"

namespace FRANKEN_API franken {

/// Holds a scene against what scene.h says of it: arrays as long as each other, indices in range, triangles whole,
/// numbers finite, normals present and not 0, images with as many bytes as their size says. loadGltf() returns
/// scenes that pass; this is for those that an application makes. Fails with "scene.data", and says which element
/// is wrong. Takes a pass over all vertices and indices. Safe on any thread.
Result<void> check(const Scene& scene);

/// Likewise, of a material alone that is to become one of the scene's. Needs none of its pixels and vertices.
Result<void> check(const Scene& scene, const Material& material);

} // namespace franken
