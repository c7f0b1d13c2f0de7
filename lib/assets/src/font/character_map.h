// SPDX-License-Identifier: MIT
#pragma once

#include "font/table.h"
#include "franken/result.h"

#include <cstdint>
#include <vector>

namespace franken {

/// Which glyph shows a character: a font's table cmap, in its formats 4 and 12 of Unicode. (OpenType 1.9,
/// "cmap")
class CharacterMap {
public:
    /// Fails with "font.format", and with "font.unsupported" where it has neither format.
    static Result<CharacterMap> read(const FontTable& table, int glyphs);

    /// 0, which every font has, where it has none for this one.
    std::uint16_t glyphOf(char32_t code) const;

private:
    /// Consecutive characters with consecutive glyphs.
    struct Range {
        char32_t first, last;
        std::uint16_t glyph; ///< Of `first`.
    };

    Result<void> readSegments(const FontTable& table);
    Result<void> readGroups(const FontTable& table);
    /// In order; glyphs that are not there are left out.
    void add(char32_t first, char32_t last, std::uint32_t glyph);

    std::uint32_t m_glyphs = 0;
    std::vector<Range> m_ranges; ///< In order, without overlaps.
};

} // namespace franken
