// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace kiosk {

/// All settings with their documentation and defaults, as a TOML file that changes nothing.
std::string exampleConfig();

} // namespace kiosk
