// SPDX-License-Identifier: MIT
#pragma once

#include "franken/sampling.h"

namespace price {

/// Texels that a pixel brings from memory on average, of a texture of which `density` texels of its largest
/// level lie under a pixel (area by area; above 0). Each texel of the level that is looked at is counted
/// once, as a cache does for pixels side by side:
///
/// - Magnified, or density up to 1: as many as there are, `density`.
/// - With mipmaps: the level's, 1 to 4 a pixel, and a quarter as many of the next one where the filter mixes
/// two.
/// - Minified without mipmaps: neighbours are not side by side in memory, and each pixel brings a line of 64
///   bytes, kLineTexels, or all texels under it where they are fewer.
double texelsPerPixel(double density, franken::Filter filter);

/// RGBA, 8 bits each: what the renderer uploads for every role, whatever the image had.
inline constexpr double kTexelBytes = 4;

/// Texels in a line of the cache. The 64 bytes are those of a micro-tile of VideoCore IV (Architecture
/// Reference Guide, "Texture memory formats"); that all of it is fetched is an estimate.
inline constexpr double kLineTexels = 64 / kTexelBytes;

/// How many texels the texture unit filters for a fetch, in lookups of four: two where two levels are mixed.
int lookupsOf(franken::Filter filter);

} // namespace price
