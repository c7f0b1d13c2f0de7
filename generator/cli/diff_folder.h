// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/permutation.h"

#include <filesystem>
#include <string>
#include <vector>

namespace franken::cli {

/// A program of a folder that `dump -o` wrote, and how it would be written today.
struct FolderProgram {
    std::string name;             ///< As the folder has it.
    std::string vertex, fragment; ///< The unified differences of its texts; empty where they are the same.
    std::string refused;          ///< Why there is no such program today; empty where there is one.

    bool same() const { return vertex.empty() && fragment.empty() && refused.empty(); }
};

/// Compares all programs that the folder's manifest.json lists. Fails with "diff.folder" where there is none,
/// it is no such document, it names a file outside of the folder, or a file cannot be read.
Result<std::vector<FolderProgram>> compareFolder(const std::filesystem::path& folder);

} // namespace franken::cli
