// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace FRANKEN_API franken {

/// A line of a manifest: a program's name, and the state that it is drawn in.
struct ManifestLine {
    std::string_view name;
    std::string_view state; ///< Words with a '=', separated by spaces; the runtime reads them. May be empty.
    std::size_t number = 0; ///< From 1.
};

/// Splits a manifest, which is text for people and for programs: a name a line, after it what is needed of
/// the state ("basecolor+sun1 wrap0=cr"); '#' begins a comment, empty lines are skipped. A line whose further
/// words have no '=' is all name, so that whoever reads the name refuses it. Names are not looked at. The
/// lines refer to the text.
std::vector<ManifestLine> manifestLines(std::string_view text);

} // namespace franken
