// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "gltf/document.h"

namespace franken::gltf {

/// By file node: its place in Scene::nodes; kNone where there are none.
using NodePlaces = std::vector<int>;

/// The nodes below `roots`, each after its parent, first children first, and each once.
std::vector<int> depthFirst(const tinygltf::Model& model, const std::vector<int>& roots);
/// The nodes that are nobody's child.
std::vector<int> allRoots(const tinygltf::Model& model);

glm::dmat4 localMatrix(const tinygltf::Node& node);

/// KHR_node_visibility, of the node alone.
bool isVisible(const tinygltf::Node& node);

/// Fills Scene::nodes, whatever scene they are in: a skin's joints may be anywhere. Where they would take
/// more than half of the memory that is left, there are none, with a warning, and nothing can be posed.
bool readSkeleton(Document& source, Scene& scene, NodePlaces& places);

} // namespace franken::gltf
