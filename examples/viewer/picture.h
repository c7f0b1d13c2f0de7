// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/pack.h"
#include "franken/image.h"

/// Of half the width and height (even numbers). Averages codes, not light: what a display and MSAA on a GPU
/// without sRGB targets do.
franken::Image halved(const franken::Image& image);

/// Puts the picture into a larger one, `x` pixels from its left and at its top.
void paste(const franken::Image& picture, int x, franken::Image& into);

/// What of a picture on a background of one colour (encoded, 0-1) shows something else.
struct Coverage {
    std::size_t shown = 0; ///< Pixels of another colour than the background.
    std::size_t white = 0; ///< Of these: as bright as the display goes in all channels.
};
Coverage coverageOf(const franken::Image& image, const franken::Float3& background);
