// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace franken::cli {

/// One rule of make, as gcc -MD writes it and ninja reads it: that the target is out of date when a source is
/// newer. Spaces, '#' and '$' of names are escaped.
std::string depfileText(const std::string& target, const std::vector<std::string>& sources);

} // namespace franken::cli
