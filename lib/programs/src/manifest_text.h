// SPDX-License-Identifier: MIT
#pragma once

#include "franken/manifest.h"

namespace franken {

/// The lines of these programs alone. One whose effect the set has not got has no name, and no line.
std::string manifestLinesOf(std::span<const ProgramUse> uses, const SnippetSet& snippets);

/// A whole manifest of such lines.
std::string manifestOfLines(const std::string& lines);

/// A line whose program has an effect that the set has not got, or with another text.
struct SkippedLine {
    std::string text; ///< With its end.
    Error error;      ///< "effect.missing" or "effect.changed".
};

struct ManifestContents {
    std::vector<ProgramUse> uses;
    std::vector<SkippedLine> skipped;
};

/// As parseManifest(), which tells of what is skipped.
Result<ManifestContents> readContents(std::string_view text, const std::string& name,
                                      const SnippetSet& snippets);

} // namespace franken
