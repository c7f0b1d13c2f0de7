// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/manifest.h"
#include "franken/result.h"

#include <memory>
#include <string>
#include <vector>

namespace franken::cli {

/// A list of names, as parseManifestLines() takes it.
struct Manifest {
    std::string file; ///< As errors call it: "warm.txt", "<stdin>".
    std::string text;
    std::vector<ManifestLine> lines; ///< Views of the text.
};

/// The longest list of names that is read, in bytes: some forty thousand names.
inline constexpr std::size_t kMaxListBytes = std::size_t{4} << 20U;

/// Reads a list of names from a file, a pipe, or standard input ("-"). The names are not looked at. Fails
/// with "manifest.read" where it cannot be read, with "manifest.size" beyond kMaxListBytes, and as
/// parseManifestLines() does.
Result<std::unique_ptr<Manifest>> readManifest(const std::string& file);

} // namespace franken::cli
