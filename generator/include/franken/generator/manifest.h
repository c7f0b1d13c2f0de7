// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/result.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace FRANKEN_API franken {

/// A line of a manifest: a program's name, and the GL state in which it draws.
struct ManifestLine {
    std::string_view name;  ///< As toName() writes it.
    std::string_view state; ///< Words with a '=', separated by spaces; the runtime reads them. May be empty.
    std::size_t number = 0; ///< From 1.
};

/// Splits a manifest, which is text for people and for programs: on each line a name, followed by the state
/// that is not the usual one ("basecolor+sun1 wrap0=cr"); '#' begins a comment, empty lines are skipped. If
/// further words have no '=', the whole line counts as the name, which parseName() then refuses. Names are
/// not checked. The lines refer to the text.
std::vector<ManifestLine> manifestLines(std::string_view text);

/// The lines of a checked manifest.
struct ManifestLines {
    std::vector<ManifestLine> lines; ///< They refer to the text.
    bool byUs;                       ///< wholeManifest() made the text.
};

/// Splits a manifest and checks it; all programs read manifests with this function. A text by wholeManifest()
/// has a first line with the schema, and a last line with the number of programs and the CRC-32 of everything
/// before it, by which a cut or changed text is recognised. A list written by hand needs neither. Fails with
/// "manifest.schema" (another version's), "manifest.damaged" (cut or changed) and "manifest.empty" (a list by
/// hand without a name). Errors call the text `name`.
Result<ManifestLines> parseManifestLines(std::string_view text, const std::string& name);

/// A whole manifest: `count` lines, each with its line end, between a first and a last line as above.
std::string wholeManifest(const std::string& lines, std::size_t count);

/// Whether wholeManifest() made the text: it has the first line, or the last one, of such a text.
bool isByUs(std::string_view text);

/// Whether a text is the rest of a manifest by wholeManifest() that was cut within its first line, or whose
/// content a file system lost.
bool isTorn(std::string_view text);

} // namespace franken
