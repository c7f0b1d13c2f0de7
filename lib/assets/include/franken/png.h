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
/// padding. `effort`: how many matches it tries for each byte. Takes some 50 ms for each million pixels; one
/// thread at a time.
std::vector<std::uint8_t> encodePng(int width, int height, int channels, std::span<const std::uint8_t> pixels,
                                    int effort = 8);

enum class PngChannels { Rgb, Rgba };

/// Writes 8 bits a channel, with alpha or without. Whoever looks sees the old picture or the new one. Fails
/// with "image.pixels" where the image's size and its bytes differ, and as writeFile() does. Takes as long as
/// encodePng(), and as the disk does.
Result<void> writePng(const std::filesystem::path& path, const Image& image,
                      PngChannels channels = PngChannels::Rgb);

} // namespace franken
