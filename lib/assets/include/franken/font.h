// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/result.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

/// TrueType fonts: widths, kerning, and glyphs as pixels. text_layout.h makes lines of them, OverlayText
/// draws those.
namespace FRANKEN_API franken {

/// The largest file that loadFont() and parseFont() take unless told otherwise: above every font of Debian
/// with TrueType outlines.
inline constexpr std::size_t kMaxFontBytes = std::size_t{32} << 20;

/// The smallest and the largest size of text, in pixels of an em.
/// Sizes of TextStyle::pixels.
inline constexpr float kMinTextPixels = 4, kMaxTextPixels = 256;
/// The largest width and height of a glyph's bitmap.
inline constexpr int kMaxGlyphPixels = 500;

/// How much of each pixel a glyph covers, 0 to 255, rows from the top down. Empty where it covers nothing.
struct GlyphBitmap {
    int left = 0, top = 0;     ///< From the pen on the baseline to the upper left pixel; pixels, y downwards.
    int width = 0, height = 0; ///< Pixels; 0 for a space.
    std::vector<std::uint8_t> coverage; ///< width * height
};

/// A font that was read. Copies share it, and all may be used on any thread. Lengths are in ems: times the
/// size of the text in pixels, they are pixels. There is no hinting, and no shaping: a character is a glyph,
/// from left to right.
class Font {
public:
    float ascent() const;  ///< From the baseline to the top of a line.
    float descent() const; ///< From the baseline to the bottom of a line; positive.
    float lineGap() const; ///< Between a line's bottom and the next one's top; 0 or more.

    /// The glyph of a character; 0, the glyph for what is missing, where the font has none.
    std::uint16_t glyphOf(char32_t code) const;
    /// From a glyph's pen to the next one's. 0 for a glyph that is not there.
    float advance(std::uint16_t glyph) const;
    /// What is added to the left one's advance where these two are neighbours, below 0 mostly: of GPOS's pair
    /// adjustments (feature `kern`, formats 1 and 2), or of the table kern (format 0) where GPOS has none.
    float kerning(std::uint16_t left, std::uint16_t right) const;

    /// Rasterises a glyph with stb_truetype: 2 µs at 20 pixels on a desktop's core, 34 µs at 256. `pixels` is
    /// the size of the em, clamped to kMinTextPixels and kMaxTextPixels. Glyph 0 is a box where the font's
    /// own is empty or broken. Fails with "font.glyph" for one that is broken or not there, and with
    /// "font.size" where it would be larger than kMaxGlyphPixels.
    Result<GlyphBitmap> bitmap(std::uint16_t glyph, float pixels) const;

    /// Whether both are copies of one font.
    bool operator==(const Font&) const = default;

private:
    struct Data;
    explicit Font(std::shared_ptr<const Data> data) : m_data(std::move(data)) {}
    friend Result<Font> parseFont(std::vector<std::uint8_t> bytes, std::size_t maxBytes);

    std::shared_ptr<const Data> m_data;
};

/// Reads a font with TrueType outlines (.ttf). Its offsets are checked before anything follows them; a broken
/// glyph costs that glyph alone, broken kerning is none. Fails with "font.format" where it is broken, with
/// "font.unsupported" for PostScript outlines (.otf), collections (.ttc), WOFF, and fonts without Unicode,
/// and with "font.limit". Takes 0.5 ms for DejaVu Sans on a desktop's core. Safe on any thread.
Result<Font> parseFont(std::vector<std::uint8_t> bytes, std::size_t maxBytes = kMaxFontBytes);

/// The same of a file. Fails as readFile(), too.
Result<Font> loadFont(const std::filesystem::path& file, std::size_t maxBytes = kMaxFontBytes);

} // namespace franken
