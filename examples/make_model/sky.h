// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "franken/result.h"

namespace make_model {

/// An evening by a lake, with the sun low on the left of -Z: writes it as a Radiance .hdr (Ward, "Real
/// Pixels", Graphics Gems II, 1991) of 4096 x 2048 texels in the layout of franken::Environment. Unlike the
/// model's, its numbers come from exp and sin as well: no stored picture depends on them. Fails with
/// "make_model.write".
franken::Result<void> writeSky(const std::filesystem::path& path);

} // namespace make_model
