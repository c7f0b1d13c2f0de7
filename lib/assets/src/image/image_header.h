// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "franken/result.h"

namespace franken {

/// What an encoded image says of itself, read without decoding anything.
struct ImageHeader {
    int width = 0;  ///< Pixels, at least 1.
    int height = 0; ///< Pixels, at least 1.

    /// What stb_image allocates to decode it to RGBA8, the pixels included, at most. A decoder that wants
    /// more has been lied to.
    std::size_t decodingBytes = 0;

    /// The decoded pixels, RGBA8.
    std::size_t pixelBytes() const {
        return std::size_t{4} * static_cast<unsigned>(width) * static_cast<unsigned>(height);
    }
};

/// Reads the header of a PNG (ISO/IEC 15948, 11.2.2) or JPEG (ITU-T T.81, B.2.2). Refused, because decoding
/// them does harm, or costs far more than their size lets expect:
/// - more pixels than that many bytes can hold: deflate packs 1,032 bytes into one at best, and JPEG spends
/// at
///   least a bit on each block of 64;
/// - an empty first chunk of pixels in a PNG, which stb_image 2.27 copies to a null pointer;
/// - a Huffman table of more than 256 symbols in a JPEG, past whose end stb_image 2.27 would write;
/// - more than 100 scans in a JPEG: each passes over all of the picture, and encoders make about ten.
///
/// Fails with "image.format" or "image.size" (wider or higher than `maxSize`). Safe on any bytes.
Result<ImageHeader> readImageHeader(std::span<const std::uint8_t> encoded, int maxSize);

} // namespace franken
