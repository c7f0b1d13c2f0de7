// SPDX-License-Identifier: MIT
#pragma once

#include "franken/result.h"

#include <string>
#include <vector>

namespace franken::cli {

struct ManifestEntry {
    std::string name;
    std::string where; ///< "warm.txt:12"
};

/// Reads a list of names, as manifestLines() takes it; states are passed over. "-" is standard input.
/// The names are not looked at. Fails with "manifest.read" where the file cannot be read, and with
/// "manifest.size" from 64 MiB on, which no list of names has.
Result<std::vector<ManifestEntry>> readManifest(const std::string& file);

} // namespace franken::cli
