// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string_view>

namespace franken {

enum class LogLevel { Info, Warning, Error };

/// Where messages go. The library itself prints nothing: whoever makes an object that has something to say
/// hands it one of these. An empty function drops the message.
using Log = std::function<void(LogLevel, std::string_view)>;

} // namespace franken
