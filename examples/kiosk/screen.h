// SPDX-License-Identifier: MIT
#pragma once

#include "franken/draw_target.h"
#include "franken/platform/surface.h"
#include "kiosk/config/config.h"

namespace kiosk {

/// How the surface is opened that the configuration asks for.
franken::platform::SurfaceOptions surfaceOptionsOf(const Config& config, franken::Log log);

/// Where to draw on it now. The background is black.
franken::DrawTarget targetOf(const franken::platform::Surface& surface);

} // namespace kiosk
