// SPDX-License-Identifier: MIT
#pragma once

#include "font/outline.h"
#include "franken/font.h"

namespace franken {

/// Which part of each pixel the outline covers, at that many pixels per unit. Fails with "font.size" where it
/// has more than kMaxGlyphPixels a side.
Result<GlyphBitmap> rasterise(const Outline& outline, float scale);

} // namespace franken
