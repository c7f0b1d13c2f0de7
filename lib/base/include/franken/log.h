// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"

#include <functional>
#include <string_view>

namespace FRANKEN_API franken {

enum class LogLevel { Info, Warning, Error };

/// Where messages go: in the caller's thread, before the call returns. The library itself prints nothing:
/// who makes an object that has something to say hands it one of these. An empty one drops the message.
using Log = std::function<void(LogLevel, std::string_view)>;

} // namespace franken
