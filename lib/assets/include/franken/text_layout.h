// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/font.h"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace FRANKEN_API franken {

/// Where the lines of a block stand in its width.
enum class TextAlign { Left, Center, Right };

/// How text is set.
struct TextStyle {
    float pixels = 24; ///< Size of the em; kMinTextPixels to kMaxTextPixels.
    float width = 0; ///< Of the block, in pixels: longer lines wrap at spaces; 0: as wide as its widest line.
    TextAlign align = TextAlign::Left; ///< Of lines in the block.
    float lineSpacing = 1;             ///< Times the font's own; above 0.
};

/// A character, and where its glyph stands.
struct PlacedGlyph {
    char32_t code = 0;       ///< As the text has it.
    std::uint16_t glyph = 0; ///< In the font; 0 for the box of what it lacks.
    float x = 0, y = 0;      ///< Of the pen on the baseline, whole pixels from the block's upper left corner.
};

/// Lines of glyphs. Spaces are not among them.
struct TextLayout {
    /// A line of the block.
    struct Line {
        std::size_t first = 0, end = 0; ///< Among the glyphs.
        float width = 0;                ///< Without spaces at its end.
    };
    std::vector<PlacedGlyph> glyphs; ///< From left to right, line by line.
    std::vector<Line> lines;         ///< From the top.
    float width = 0, height = 0;     ///< Of the block; pixels.
};

/// Lays out UTF-8, with kerning; bytes that are none count as U+FFFD. Lines end at '\n', and where a width is
/// given at spaces (not at U+00A0), or anywhere in a word that is longer than a line. A tab is four spaces;
/// characters that are not seen (isUnseen() in utf8.h) are left out. Pens are rounded to whole pixels, so
/// that a glyph has the same pixels wherever it stands. Numbers out of range are clamped. `layout` is
/// overwritten: its memory is used again, and nothing is allocated where that suffices. 36 ns per
/// character of DejaVu Sans on a desktop's core. Safe on any thread.
void layOut(const Font& font, std::string_view text, const TextStyle& style, TextLayout& layout);

} // namespace franken
