// SPDX-License-Identifier: MIT
#pragma once

#include "gltf/skeleton.h"

namespace franken::gltf {

/// Fills Scene::animations; needs Scene::nodes. An animation with a fault is left out with a warning, because
/// a picture at rest does without; what endangers memory is an error.
bool readAnimations(Document& source, const NodePlaces& places, Scene& scene);

} // namespace franken::gltf
