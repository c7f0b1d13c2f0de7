// SPDX-License-Identifier: MIT
#pragma once

#include "franken/baked_sky.h"
#include "franken/generator/pack.h"

namespace franken::gallery {

/// The numbers that the gallery's programs are fed with.
struct Blocks {
    FrameBlock frame{};
    LightsBlock lights{};
    MaterialBlock material{};
    ObjectBlock object{};
    SkinBlock skin{};
};

/// For that program.
Blocks blocksFor(const Permutation& permutation, const BakedSky& sky);

} // namespace franken::gallery
