// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/compose.h"

#include <string>
#include <vector>

namespace franken::cli {

/// A composed permutation and what it is called.
struct Program {
    explicit Program(const Permutation& canonical);

    Permutation permutation;
    std::string name;
    std::string file; ///< Its files' name without extension: the name, or the key where that is too long.
    Composed composed;
};

/// A text's lines, without their ends. They are views of the text.
std::vector<std::string_view> linesOf(std::string_view text);
std::vector<std::string_view> linesOf(std::string&& text) = delete;

} // namespace franken::cli
