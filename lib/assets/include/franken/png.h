// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/image.h"
#include "franken/result.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace FRANKEN_API franken {

/// A PNG file in memory, of 1 (grey), 3 (RGB) or 4 (RGBA) channels of 8 bits, rows from the top down without
/// padding. `effort` is the number of matches tried for each byte. Takes some 50 ms per million pixels. Call
/// it on one thread at a time.
std::vector<std::uint8_t> encodePng(int width, int height, int channels, std::span<const std::uint8_t> pixels,
                                    int effort = 8);

/// Which channels a file gets; Rgb drops the alpha.
enum class PngChannels { Rgb, Rgba };

/// Writes an image with 8 bits a channel, with or without alpha. The path holds the old or the complete new
/// file at any time. Fails with "image.pixels" where the image's size does not fit its bytes, and as
/// writeFile() does. Takes the time of encodePng() and of the disk.
Result<void> writePng(const std::filesystem::path& path, const Image& image,
                      PngChannels channels = PngChannels::Rgb);

} // namespace franken
