// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>

namespace franken::cli {

/// The text at the left, or at the right, of a column of that many characters; never cut.
inline std::string left(std::string text, std::size_t width) {
    text.resize(std::max(width, text.size()), ' ');
    return text;
}

inline std::string right(const std::string& text, std::size_t width) {
    return std::string(width - std::min(width, text.size()), ' ') + text;
}

} // namespace franken::cli
