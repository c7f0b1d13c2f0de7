// SPDX-License-Identifier: MIT
#pragma once

#include "franken/result.h"
#include "franken/scene.h"

namespace franken {

/// What check(scene) demands of nodes and animations. Fails with "scene.data".
Result<void> checkMotion(const Scene& scene);

} // namespace franken
