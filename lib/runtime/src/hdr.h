// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "franken/image.h"
#include "franken/result.h"

namespace franken {

/// Linear RGB on the CPU, rows from top to bottom.
struct FloatImage {
    int width = 0;
    int height = 0;
    std::vector<glm::vec3> texels; ///< 0 to 1e9.
};

/// Whether these bytes start as a Radiance picture does.
bool isHdr(std::span<const std::uint8_t> file);

/// Decodes a Radiance picture (Ward, "Real Pixels", Graphics Gems II, 1991) with rows from top to bottom,
/// plain or run-length encoded (the runs of before 1991 are not read). A texel is mantissa * 2^(exponent -
/// 136). Fails with "hdr.format" or "hdr.size". Safe on any bytes.
Result<FloatImage> decodeHdr(std::span<const std::uint8_t> file, int maxSize);

/// Decodes a PNG or JPEG and takes its codes as sRGB.
Result<FloatImage> decodeSrgbImage(std::span<const std::uint8_t> file, int maxSize);

} // namespace franken
