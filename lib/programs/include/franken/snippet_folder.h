// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/effect.h"
#include "franken/generator/snippet_set.h"

#include <filesystem>

namespace FRANKEN_API franken {

/// Reads NAME.glsl for each name of SnippetSet::names() from a folder that is laid out as generator/glsl is.
/// Fails as SnippetSet::make() does, and with "snippet.file" where a file cannot be read, is empty, or is
/// larger than 64 KiB; `where` is its path.
Result<SnippetSet> readSnippets(const std::filesystem::path& folder);

/// Reads an effect of an application's, which is called as its file is, without ".glsl". Fails as
/// Effect::parse() does, and with "snippet.file".
Result<Effect> readEffect(const std::filesystem::path& file);

} // namespace franken
