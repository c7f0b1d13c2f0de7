// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/snippet_set.h"

#include <filesystem>
#include <string>
#include <vector>

namespace franken::cli {

/// The snippets of this run: the built-in ones, with the effects of --effects.
const SnippetSet& snippets();

/// The files that these effects were read from.
const std::vector<std::filesystem::path>& effectFiles();

/// Adds the effect of a file, or of each .glsl file of a folder, to them; its name is the file's without
/// ".glsl". Fails with "effect.file" where it cannot be read or a folder holds none, and as Effect::parse()
/// and SnippetSet::with() do.
Result<void> addEffects(const std::vector<std::string>& paths);

} // namespace franken::cli
