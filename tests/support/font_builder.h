// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <initializer_list>
#include <map>
#include <string>
#include <vector>

/// Fonts made by tests: the same bytes on every run.
namespace franken::test {

/// Big-endian.
std::string u16(std::initializer_list<int> values);
std::string u32(std::initializer_list<std::uint32_t> values);

/// A TrueType file by its tables. `bytes()` writes them in the order of their names.
struct FontFile {
    std::uint32_t format = 0x00010000;
    std::map<std::string, std::string> tables;

    /// Makes glyf and loca, of 16-bit or 32-bit offsets.
    void setGlyphs(const std::vector<std::string>& glyphs, bool longOffsets = true);
    std::vector<std::uint8_t> bytes() const;
};

struct FontPoint {
    int x, y;
    bool onCurve = true;
};

/// A glyph of contours, its points as 16-bit steps.
std::string contours(const std::vector<std::vector<FontPoint>>& shapes);
/// A part of a composite glyph, at a half of its size: at an offset; at an offset that is scaled, too; with
/// its point `on` at the whole's point `of`.
std::string halfPart(int glyph, int x, int y, bool more);
std::string scaledHalfPart(int glyph, int x, int y);
std::string hungHalfPart(int glyph, int of, int on);
/// A composite glyph of parts.
std::string composite(const std::string& parts);

/// The glyphs of soundFont(), 1000 units an em.
enum SoundGlyph : std::uint16_t { Missing, Space, SquareA, TriangleV, HalvesB, RoundO, kSoundGlyphs };

/// Its glyphs, as glyf has them: none for what is missing and for the space.
std::vector<std::string> soundGlyphs();

/// 'A' is a square from 100 to 900 by 0 to 800; 'V' a triangle with its corners at (0, 800), (1000, 800) and
/// (500, 0); 'B' two A of half the size, at (0, 0) and (500, 400); 'o' four points off the curve, the corners
/// of the square from 0 to 600. All are 1000 wide, the space 500. U+1F600 is an A, too.
/// Ascent 800, descent 200, gap 100.
/// 'A' and 'V' are 150 nearer by kern.
FontFile soundFont();

/// A table cmap of segments (format 4), which knows U+0020, A, B, V, o.
std::string segmentMap();

/// A table GPOS: 'A' 'V' -200 and 'A' 'o' -100 by format 1; 'V' before 'A' or 'B' -300 by format 2. The second one's subtable
/// stands behind an extension.
std::string pairPositioning();

} // namespace franken::test
