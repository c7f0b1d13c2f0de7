// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/draw_state.h"
#include "franken/material.h"

#include <vector>

namespace FRANKEN_API franken {

/// The GL state with which a material of the scene is drawn.
DrawState drawStateOf(const Scene& scene, const MaterialPlan& plan, bool blended);

/// The materials of a scene that are included: those without a variant, or those of all variants as well.
enum class Variants { None, All };

/// The programs that draw a scene in that light and look, with their state, without repetitions. Needs no GL.
/// If lights go on and off, call it once for each lighting that will occur; if materials will be changed,
/// with a scene that has the changed materials. Fails where canonicalise() does.
Result<std::vector<ProgramUse>> usesOf(const Scene& scene, const Lighting& lighting, const Look& look,
                                       const Log& log = {}, Variants variants = Variants::None);

/// The program that draws a skybox.
Result<ProgramUse> skyboxUse(const Look& look);

} // namespace franken
