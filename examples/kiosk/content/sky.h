// SPDX-License-Identifier: MIT
#pragma once

#include "franken/baked_sky.h"

#include <filesystem>
#include <memory>

namespace kiosk {

using Sky = std::shared_ptr<const franken::BakedSky>;

/// Reads a sky with its sun taken out. Filtering one that is not baked takes most of a minute. Fails as
/// loadSky().
franken::Result<Sky> readSky(const std::filesystem::path& path);

} // namespace kiosk
