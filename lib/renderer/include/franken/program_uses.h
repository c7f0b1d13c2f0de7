// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/draw_state.h"
#include "franken/material.h"

#include <vector>

namespace FRANKEN_API franken {

/// The state that a material of the scene is drawn in.
DrawState drawStateOf(const Scene& scene, const MaterialPlan& plan, bool blended);

/// Which materials of a scene are asked for: those without a variant, or those of all variants as well.
enum class Variants { None, All };

/// What a scene needs in that light and look, each once. Needs no GL. For lights that go on and off: once for
/// each lighting that will occur; for materials that will be changed: with a scene that has them. Fails where
/// canonicalise() does.
Result<std::vector<ProgramUse>> usesOf(const Scene& scene, const Lighting& lighting, const Look& look,
                                       const Log& log = {}, Variants variants = Variants::None);

/// What a skybox needs.
Result<ProgramUse> skyboxUse(const Look& look);

} // namespace franken
