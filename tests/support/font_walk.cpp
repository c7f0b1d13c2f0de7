// SPDX-License-Identifier: MIT
#include "support/font_walk.h"

#include "franken/font.h"
#include "franken/text_layout.h"

#include <array>
#include <cmath>

namespace franken::test {
namespace {

constexpr std::uint16_t kMaxGlyphs = 24; ///< Of those that a file says it has; a fuzzer has little time.

bool isOneOf(const std::string& code, std::initializer_list<const char*> codes) {
    for (const char* known : codes)
        if (code == known)
            return true;
    return false;
}

std::string brokenPromiseOf(const GlyphBitmap& bitmap) {
    if (bitmap.width < 0 || bitmap.height < 0 || bitmap.width > kMaxGlyphPixels ||
        bitmap.height > kMaxGlyphPixels)
        return "a bitmap's size is in range";
    const auto pixels = static_cast<std::size_t>(bitmap.width) * static_cast<std::size_t>(bitmap.height);
    return bitmap.coverage.size() == pixels ? "" : "a bitmap has all its pixels";
}

std::string brokenPromiseOf(const Font& font, std::uint16_t glyph, float pixels) {
    const Result<GlyphBitmap> bitmap = font.bitmap(glyph, pixels);
    if (bitmap)
        return brokenPromiseOf(*bitmap);
    if (glyph == 0 && bitmap.error().code == "font.glyph")
        return "the missing glyph can be drawn";
    return isOneOf(bitmap.error().code, {"font.glyph", "font.size"}) ? "" : "a glyph's error is documented";
}

std::string brokenPromiseOf(const Font& font) {
    if (!(font.ascent() + font.descent() > 0) || !(font.lineGap() >= 0))
        return "lines have a height";
    for (std::uint16_t glyph = 0; glyph < kMaxGlyphs; ++glyph) {
        if (!(font.advance(glyph) >= 0))
            return "advances are 0 or more";
        for (std::uint16_t right = 0; right < kMaxGlyphs; ++right)
            if (!std::isfinite(font.kerning(glyph, right)))
                return "kerning is finite";
        for (const float pixels : std::array{4.0f, 23.5f, glyph < 2 ? 256.0f : 64.0f})
            if (std::string broken = brokenPromiseOf(font, glyph, pixels); !broken.empty())
                return broken;
    }
    TextLayout layout;
    layOut(font, "AV BoA\xF0\x9F\x98\x80\n\xFFVA", {.pixels = 20, .width = 60, .align = TextAlign::Center},
           layout);
    return layout.glyphs.size() == 9 && std::isfinite(layout.height) ? "" : "each character has its glyph";
}

} // namespace

std::string brokenPromiseOf(std::span<const std::uint8_t> file) {
    const Result<Font> font = parseFont({file.begin(), file.end()});
    if (font)
        return brokenPromiseOf(*font);
    const Error& error = font.error();
    if (!isOneOf(error.code, {"font.format", "font.unsupported", "font.limit"}))
        return "a font's error is documented";
    return error.what.empty() || error.remedy.empty() ? "an error says what is wrong, and what to do" : "";
}

} // namespace franken::test
