// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace franken::cli {

/// The differences of two texts in diff's unified format, three lines of context around each; empty where
/// they are equal. A smallest set of changed lines, found in time and space that grow with the product of the
/// texts' lengths: for shaders, not for logs.
std::string unifiedDiff(std::string_view firstName, std::string_view first, std::string_view secondName,
                        std::string_view second);

} // namespace franken::cli
