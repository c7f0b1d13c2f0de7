// SPDX-License-Identifier: MIT
#pragma once

#include "font/table.h"
#include "franken/result.h"

#include <cstdint>
#include <span>
#include <vector>

namespace franken {

/// The tables of a TrueType file, with their offsets and lengths checked, and the numbers that others need.
struct FontTables {
    FontTable characters;                    ///< cmap
    FontTable outlines;                      ///< glyf
    FontTable kerning;                       ///< kern; may be empty.
    FontTable positioning;                   ///< GPOS; may be empty.
    FontTable horizontalMetrics;             ///< hmtx
    std::vector<std::uint32_t> glyphOffsets; ///< Into `outlines`, not decreasing; one more than glyphs.
    int glyphs = 0;
    int horizontalMetricsCount = 0; ///< 1 to `glyphs`; later glyphs have the last one's advance.
    int unitsPerEm = 0;             ///< 16 to 16384
    int ascent = 0, descent = 0;    ///< Above and below the baseline, both upwards.
    int lineGap = 0;
};

/// Of a whole file. Fails with "font.format" and "font.unsupported". (OpenType 1.9, "OpenType font file",
/// head, hhea, hmtx, loca and maxp.)
Result<FontTables> readFontTables(std::span<const std::uint8_t> file);

/// Fails with "font.format": broken, and where.
Error fontError(const char* table, const std::string& what);

} // namespace franken
