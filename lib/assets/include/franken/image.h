// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "franken/api.h"
#include "franken/result.h"

namespace FRANKEN_API franken {

/// Pixels on the CPU: RGBA, 8 bits a channel, rows from top to bottom without padding. The first pixel is
/// the one at texture coordinate (0, 0), as glTF has it and as glTexImage2D wants it. Whether the numbers
/// are sRGB or linear is a matter of the texture's role, not of the image.
struct Image {
    std::string name;               ///< From the file, for messages; may be empty.
    int width = 0;                  ///< Pixels; 0 only in an image that was never filled.
    int height = 0;                 ///< Pixels.
    std::vector<std::uint8_t> rgba; ///< width * height * 4 bytes; none while it is encoded.

    /// The PNG or JPEG that the pixels are still in, where there are none in `rgba`: a fiftieth of their
    /// memory. A renderer decodes it when it uploads it, one image at a time.
    std::vector<std::uint8_t> encoded = {};
};

/// The largest width and height that decodeImage() takes unless told otherwise. Every texture limit of a
/// Raspberry Pi is below it; the pixels of one such image fill 256 MiB.
inline constexpr int kMaxImageSize = 8192;

/// Decodes a PNG or a JPEG (nothing else) to RGBA8. Grey becomes R = G = B, a missing alpha 255, and 16-bit
/// channels lose their lower byte. The header is read first, so that an image over `maxSize` costs nothing.
///
/// Fails with "image.format" (neither PNG nor JPEG, or broken) or "image.size" (too wide or too high).
/// Safe on any thread.
Result<Image> decodeImage(std::span<const std::uint8_t> encoded, int maxSize = kMaxImageSize);

/// The image with its pixels in `rgba`; a copy where they are there already. Fails as decodeImage() does.
/// Safe on any thread.
Result<Image> withPixels(const Image& image);

} // namespace franken
