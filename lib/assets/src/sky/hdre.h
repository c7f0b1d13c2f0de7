// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "franken/environment.h"

namespace franken {

/// Whether these bytes start as an HDRE environment does.
bool isHdre(std::span<const std::uint8_t> file);

/// Reads level 0 of an HDRE environment, whose six faces are the sky; the other levels are filtered by the
/// writer's own kernel, and only their length is checked. Versions 1 to 3 with texels of three or four floats
/// are read; the fourth channel is left out. Radiances below 0 become 0, and those above 1e9 become 1e9.
/// Fails with "hdre.format", "hdre.size" (faces wider than `maxFace`, empty or not square) or, before it
/// takes more than `maxBytes` of memory, "sky.limit". Safe on any bytes.
Result<Environment> decodeHdre(std::span<const std::uint8_t> file, int maxFace, std::size_t maxBytes);

} // namespace franken
