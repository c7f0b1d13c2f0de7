// SPDX-License-Identifier: MIT
#pragma once

#include "franken/manifest.h"

namespace franken {

/// Whether toManifest() made the text: it has the first line, or the last one, of such a text.
bool isByUs(std::string_view text);

/// Whether a text is what a cut through the first line, or a file system that lost the content, leaves of one
/// of ours.
bool isTorn(std::string_view text);

/// The lines of these programs alone, for a list that someone wrote by hand.
std::string manifestLinesOf(std::span<const ProgramUse> uses);

} // namespace franken
