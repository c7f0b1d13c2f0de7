// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "franken/environment.h"

namespace franken::test {

/// Skies that are hard to filter and to store, by formulas: a dark room with soft boxes, one lamp of two
/// degrees, half a sky, a clear one, and six suns. Nothing was fitted to them.
enum class HardSky { SoftBoxes, Lamp, Half, Gradient, Suns };

inline constexpr std::array kHardSkies = {HardSky::SoftBoxes, HardSky::Lamp, HardSky::Half, HardSky::Gradient,
                                          HardSky::Suns};

const char* toString(HardSky sky);

/// 256 x 128 texels, exposed so that their mean luminance is 0.5.
Environment makeHardSky(HardSky sky);

} // namespace franken::test
