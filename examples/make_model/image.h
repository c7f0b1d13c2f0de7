// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace make_model {

/// Pixels of 8 bits a channel, rows from the top down, without padding.
struct Image {
    int width = 0;
    int height = 0;
    int channels = 3; ///< 1 grey or 3 RGB.
    std::vector<std::uint8_t> pixels;
};

/// The image as a PNG file in memory.
std::vector<std::uint8_t> encodePng(const Image& image);

/// A value of 0 to 1 as a byte, rounded; values outside are clamped.
std::uint8_t toByte(double value);

} // namespace make_model
