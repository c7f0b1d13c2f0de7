// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/pack.h"

#include <array>

namespace FRANKEN_API franken {

/// Where a picture goes.
struct DrawTarget {
    unsigned framebuffer = 0;            ///< A GL name; with a depth buffer.
    int width = 0, height = 0;           ///< Pixels; the viewport begins at the lower left corner.
    Float3 background{0, 0, 0};          ///< As it is written: encoded unless the target encodes, 0-1.
    std::array<int, 3> bits = {8, 8, 8}; ///< Of each colour channel: what dithering goes by.
};

} // namespace franken
