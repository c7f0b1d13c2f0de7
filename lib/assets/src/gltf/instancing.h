// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <glm/ext/matrix_double4x4.hpp>

#include "gltf/document.h"

namespace franken::gltf {

/// Where the mesh of a node stands, from there to the node (EXT_mesh_gpu_instancing); at the node itself,
/// once, without the extension. A skinned mesh has one place: joints say where it is.
bool readOffsets(Document& source, int node, std::vector<glm::dmat4>& offsets);

} // namespace franken::gltf
