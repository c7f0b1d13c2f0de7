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

/// Reads the text of a manifest.json that `dump -o` wrote. Takes little more memory than the text, whatever
/// that is. Fails where the text is no JSON, lists no programs, lists something that is no program, or nests
/// deeper than `dump` does; only `what` is set.
Result<std::vector<ListedProgram>> parseFolderManifest(std::string_view text);

} // namespace franken::cli
