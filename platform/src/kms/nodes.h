// SPDX-License-Identifier: MIT
#pragma once

#include "device.h"

namespace franken::platform {

/// The device with the screen that the options ask for: all nodes are looked at, whatever their numbers.
/// Where no screen is connected, the one that has the named output, or any output; null where there is none
/// (yet). Fails with `screen.permission` where that is why.
Result<std::unique_ptr<KmsDevice>> findKmsDevice(const ScreenOptions& options);

/// Who has the node open beside this process: "Xorg (process 812), weston (process 4711)"; empty where
/// nobody has, or /proc does not tell.
std::string holdersOf(const std::string& node);

} // namespace franken::platform
