// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/compose.h"

#include <string>
#include <utility>

namespace franken::bench {

/// Composes as the program does that this library is named after: a template with marker words, each of
/// which is looked for from the start of the growing string and replaced by a piece of GLSL and itself.
/// Makes the same bytes as compose(), from the same snippets, and asks the same functions which of them a
/// permutation needs; but it makes neither interface nor line map. Vertex and fragment shader.
std::pair<std::string, std::string> composeByReplacing(const Permutation& permutation);

} // namespace franken::bench
