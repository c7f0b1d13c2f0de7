// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/compose.h"

#include <string>
#include <vector>

namespace franken::cli {

/// The snippets of this run: the built-in ones, with the effects of --effects.
const SnippetSet& snippets();

/// Adds the effect of a file, or of each .glsl file of a folder, to them; its name is the file's without
/// ".glsl". Fails with "effect.file" where it cannot be read or a folder holds none, and as Effect::parse()
/// and SnippetSet::with() do.
Result<void> addEffects(const std::vector<std::string>& paths);

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
