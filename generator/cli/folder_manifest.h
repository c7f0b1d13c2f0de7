// SPDX-License-Identifier: MIT
#pragma once

#include "franken/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace franken::cli {

/// What a folder's manifest.json says of one of its programs.
struct ListedProgram {
    std::string name;
    std::string vertex, fragment; ///< Files beside it.
};

/// Reads the text of a manifest.json that `dump -o` wrote, and keeps nothing else of it than this: whatever
/// the text is, it takes little more memory than itself. Fails where it is no JSON, or lists no programs, or
/// what is no program, or nests deeper than ours do; `what` alone is set.
Result<std::vector<ListedProgram>> parseFolderManifest(std::string_view text);

} // namespace franken::cli
