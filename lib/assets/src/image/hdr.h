// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
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

/// Whether a decoded texel is a number at all.
bool isFinite(const glm::vec3& texel);

/// Within the range of FloatImage::texels.
glm::vec3 clampedRadiance(const glm::vec3& texel);

/// "sky.limit": a sky that needs more memory than SkyLimits allow.
Error memoryError(std::string where);

/// Decodes a Radiance picture (Ward, "Real Pixels", Graphics Gems II, 1991) with rows from top to bottom,
/// plain or run-length encoded (the runs of before 1991 are not read). A texel is mantissa * 2^(exponent -
/// 136). Fails with "hdr.format", "hdr.size" or, before it takes more than `maxBytes` of memory, "sky.limit".
/// Safe on any bytes.
Result<FloatImage> decodeHdr(std::span<const std::uint8_t> file, int maxSize, std::size_t maxBytes);

/// Decodes a PNG or JPEG and takes its codes as sRGB. Fails as decodeImage() does, or with "sky.limit".
Result<FloatImage> decodeSrgbImage(std::span<const std::uint8_t> file, int maxSize, std::size_t maxBytes);

} // namespace franken
