// SPDX-License-Identifier: MIT
#pragma once

#include "franken/image.h"
#include "franken/result.h"

#include <filesystem>

/// Writes RGB, 8 bits a channel; alpha is left out. Fails with "png.write".
franken::Result<void> writePng(const std::filesystem::path& path, const franken::Image& image);

/// Likewise, but in one step: beside the file, and then in its place. Whoever looks sees the old picture or
/// the new one.
franken::Result<void> replacePng(const std::filesystem::path& path, const franken::Image& image);
