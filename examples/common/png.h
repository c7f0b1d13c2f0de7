// SPDX-License-Identifier: MIT
#pragma once

#include "franken/image.h"
#include "franken/result.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

/// A PNG file in memory, of 1 (grey) or 3 (RGB) channels of 8 bits, rows from the top down without padding.
/// `effort`: how many matches it tries for each byte. One thread at a time.
std::vector<std::uint8_t> encodePng(int width, int height, int channels, std::span<const std::uint8_t> pixels,
                                    int effort = 8);

/// Writes RGB, 8 bits a channel; alpha is left out. Whoever looks sees the old picture or the new one. Fails as
/// writeFile() does.
franken::Result<void> writePng(const std::filesystem::path& path, const franken::Image& image);
