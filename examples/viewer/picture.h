// SPDX-License-Identifier: MIT
#pragma once

#include "franken/gl.h"
#include "franken/image.h"
#include "franken/platform/surface.h"

/// Reads back what the surface shows, which must be current: row 0 at the top.
franken::Image readTopDown(const franken::Gl& gl, const franken::platform::Surface& surface);

/// Of half the width and height (even numbers). Averages codes, not light: what a display and MSAA on a GPU
/// without sRGB targets do.
franken::Image halved(const franken::Image& image);
