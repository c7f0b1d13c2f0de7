// SPDX-License-Identifier: MIT
#pragma once

#include "franken/result.h"
#include "franken/scene.h"

namespace franken {

/// What check(scene) demands of nodes, animations, skins and morphs. Fails with "scene.data".
Result<void> checkMotion(const Scene& scene);

} // namespace franken
