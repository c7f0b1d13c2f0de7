// SPDX-License-Identifier: MIT
#pragma once

#include "franken/log.h"
#include "franken/result.h"
#include "kiosk/command_line.h"

namespace kiosk {

/// Draws what the kiosk would show `seconds` after the first model came, and writes it as a PNG.
franken::Result<void> drawFrame(const DrawFrame& command, const Config& config, const franken::Log& log);

} // namespace kiosk
