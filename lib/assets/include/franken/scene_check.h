// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/result.h"
#include "franken/scene.h"

namespace FRANKEN_API franken {

/// Checks that a scene is as scene.h demands: arrays of equal length, indices in range, triangles whole,
/// numbers finite, normals present and not 0, images with as many bytes as their size says. Scenes from
/// loadGltf() pass; call it for scenes that an application makes. Fails with "scene.data", which names the
/// element that is wrong. Takes one pass over all vertices and indices. Safe on any thread.
Result<void> check(const Scene& scene);

/// Checks a material that is to become one of the scene's. Needs the scene's textures, but no pixels and no
/// vertices. Fails with "scene.data".
Result<void> check(const Scene& scene, const Material& material);

} // namespace franken
