// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"

#include <functional>
#include <string_view>

namespace FRANKEN_API franken {

/// How much a message matters.
enum class LogLevel { Info, Warning, Error };

/// Receives messages, in the caller's thread and before the call returns. The library itself prints nothing:
/// the application passes a Log to each object that reports something. An empty one drops the messages.
using Log = std::function<void(LogLevel, std::string_view)>;

} // namespace franken
