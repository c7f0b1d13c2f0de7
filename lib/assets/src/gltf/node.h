// SPDX-License-Identifier: MIT
#pragma once

#include "gltf/skeleton.h"

namespace franken::gltf {

// The camera and the light of that number, without their place in the world.

bool readCamera(Document& source, int index, Camera& camera);
/// False, with a warning, for a type that is none of directional, point and spot.
bool isKnownLight(Document& source, int index);
bool readLight(Document& source, int index, Light& light);

/// Which materials the primitives of the scene's nodes have.
std::vector<bool> materialsInScene(const Document& source);

/// Walks the scene's nodes: meshes, instances, cameras and lights. Needs the materials and Scene::nodes.
bool readNodes(Document& source, const NodePlaces& places, Scene& scene);

} // namespace franken::gltf
