// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/result.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace FRANKEN_API franken {

/// A line of a manifest: a program's name, and the state that it is drawn in.
struct ManifestLine {
    std::string_view name;
    std::string_view state; ///< Words with a '=', separated by spaces; the runtime reads them. May be empty.
    std::size_t number = 0; ///< From 1.
};

/// Splits a manifest, which is text for people and for programs: a name a line, after it what is needed of
/// the state ("basecolor+sun1 wrap0=cr"); '#' begins a comment, empty lines are skipped. A line whose further
/// words have no '=' is all name, so that whoever reads the name refuses it. Names are not looked at. The
/// lines refer to the text.
std::vector<ManifestLine> manifestLines(std::string_view text);

struct ManifestLines {
    std::vector<ManifestLine> lines; ///< They refer to the text.
    bool byUs;                       ///< wholeManifest() made the text.
};

/// Splits a manifest and checks it: the one way in which programs read them. A text that wholeManifest() made
/// has a first line with the schema, and a last one with the number of programs and the CRC-32 of all before
/// it, so that one which was cut anywhere, or changed, is told from a whole one. A list that someone wrote
/// needs neither. Fails with "manifest.schema" (another version's), "manifest.damaged" (cut or changed) and
/// "manifest.empty" (a list by hand without a name). `name` is what errors call the text.
Result<ManifestLines> parseManifestLines(std::string_view text, const std::string& name);

/// So many lines, each with its end, between a first and a last line as above.
std::string wholeManifest(const std::string& lines, std::size_t count);

/// Whether wholeManifest() made the text: it has the first line, or the last one, of such a text.
bool isByUs(std::string_view text);

/// Whether a text is what a cut through the first line, or a file system that lost the content, leaves of one
/// of wholeManifest()'s.
bool isTorn(std::string_view text);

} // namespace franken
