// SPDX-License-Identifier: MIT
#pragma once

#include "image/exr_header.h"
#include "image/hdr.h"

namespace franken {

/// Decodes an OpenEXR picture by its channels R, G and B, or Y alone, of halves or floats; others, alpha
/// among them, are left out. The picture is the display window, black where no texels are stored; where both
/// windows have one size, it is what is stored, wherever the two lie. Radiances below 0 become 0, and those
/// above 1e9 become 1e9. readExrHeader() checks the file first. Fails with "exr.format", "exr.size",
/// "exr.absent" (a build without tinyexr) or, before it takes more than `maxBytes` of memory, "sky.limit".
/// Safe on any bytes.
Result<FloatImage> decodeExr(std::span<const std::uint8_t> file, int maxSize, std::size_t maxBytes);

} // namespace franken
