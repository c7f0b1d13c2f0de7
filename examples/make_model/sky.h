// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "franken/result.h"

namespace make_model {

/// As many texels in a degree as half the pixels of the README's picture.
inline constexpr int kSkyWidth = 4096;

/// An evening by a lake, with the sun low on the left of -Z: writes it as a Radiance .hdr (Ward, "Real
/// Pixels", Graphics Gems II, 1991) of width x width / 2 texels in the layout of franken::Environment. Unlike
/// the model's, its numbers come from exp and sin as well: no stored picture depends on them. Fails with
/// "make_model.write".
franken::Result<void> writeSky(const std::filesystem::path& path, int width = kSkyWidth);

} // namespace make_model
