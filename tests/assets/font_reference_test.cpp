// SPDX-License-Identifier: MIT
// A font by others, read by FreeType and by us: the same characters, widths, kerning and pixels.
#include "franken/font.h"

#include <gtest/gtest.h>

#include <ft2build.h>
#include FT_FREETYPE_H

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>

namespace franken::test {
namespace {

constexpr const char* kFile = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

class FontReference : public testing::Test {
protected:
    void SetUp() override {
        if (!std::filesystem::exists(kFile))
            GTEST_SKIP() << "fonts-dejavu-core is not there";
        ASSERT_EQ(FT_Init_FreeType(&m_library), 0);
        ASSERT_EQ(FT_New_Face(m_library, kFile, 0, &m_face), 0);
        Result<Font> font = loadFont(kFile);
        ASSERT_TRUE(font) << toString(font.error());
        m_font = *std::move(font);
    }
    void TearDown() override {
        if (m_library != nullptr)
            FT_Done_FreeType(m_library);
    }

    long units(float ems) const { return std::lround(ems * static_cast<float>(m_face->units_per_EM)); }

    FT_Library m_library = nullptr;
    FT_Face m_face = nullptr;
    std::optional<Font> m_font;
};

TEST_F(FontReference, CharactersAndWidthsAreTheSame) {
    int differing = 0;
    for (FT_ULong code = 0; code < 0x20000; ++code)
        differing += m_font->glyphOf(static_cast<char32_t>(code)) != FT_Get_Char_Index(m_face, code);
    EXPECT_EQ(differing, 0);
    for (FT_UInt glyph = 0; glyph < static_cast<FT_UInt>(m_face->num_glyphs); ++glyph) {
        ASSERT_EQ(FT_Load_Glyph(m_face, glyph, FT_LOAD_NO_SCALE), 0);
        EXPECT_EQ(units(m_font->advance(static_cast<std::uint16_t>(glyph))),
                  m_face->glyph->metrics.horiAdvance);
    }
}

// FreeType reads the table kern, we read GPOS, which says the same of these in this font.
TEST_F(FontReference, KerningIsTheSame) {
    int kerned = 0;
    for (char left = '!'; left <= '~'; ++left)
        for (char right = '!'; right <= '~'; ++right) {
            const FT_UInt first = FT_Get_Char_Index(m_face, static_cast<FT_ULong>(left)),
                          second = FT_Get_Char_Index(m_face, static_cast<FT_ULong>(right));
            FT_Vector expected;
            ASSERT_EQ(FT_Get_Kerning(m_face, first, second, FT_KERNING_UNSCALED, &expected), 0);
            EXPECT_EQ(
                units(m_font->kerning(static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(second))),
                expected.x)
                << left << right;
            kerned += expected.x != 0;
        }
    EXPECT_GT(kerned, 100);
}

/// Codes of coverage by which two bitmaps of a glyph differ.
struct Difference {
    int largest = 0;
    double sum = 0, pixels = 0;
};

void compare(const GlyphBitmap& ours, const FT_GlyphSlot theirs, Difference& difference) {
    const FT_Bitmap& bitmap = theirs->bitmap;
    const int left = theirs->bitmap_left, top = -theirs->bitmap_top, width = static_cast<int>(bitmap.width),
              height = static_cast<int>(bitmap.rows);
    const auto ourCode = [&](int x, int y) {
        x -= ours.left, y -= ours.top;
        const bool isIn = x >= 0 && y >= 0 && x < ours.width && y < ours.height;
        return isIn ? int{ours.coverage[static_cast<std::size_t>(y * ours.width + x)]} : 0;
    };
    const auto theirCode = [&](int x, int y) {
        x -= left, y -= top;
        return x >= 0 && y >= 0 && x < width && y < height ? int{bitmap.buffer[y * bitmap.pitch + x]} : 0;
    };
    for (int y = std::min(top, ours.top); y < std::max(top + height, ours.top + ours.height); ++y)
        for (int x = std::min(left, ours.left); x < std::max(left + width, ours.left + ours.width); ++x) {
            const int codes = std::abs(ourCode(x, y) - theirCode(x, y));
            difference.largest = std::max(difference.largest, codes);
            difference.sum += codes;
            ++difference.pixels;
        }
}

// FreeType rounds points to 1/64 of a pixel; curves of ours may be 1/10 of a pixel away from theirs.
TEST_F(FontReference, PixelsAreTheSameWithinRounding) {
    Difference difference;
    for (const unsigned pixels : {12u, 24u, 64u}) {
        ASSERT_EQ(FT_Set_Pixel_Sizes(m_face, 0, pixels), 0);
        for (FT_ULong code = 0x21; code < 0x600; ++code) {
            const FT_UInt glyph = FT_Get_Char_Index(m_face, code);
            ASSERT_EQ(FT_Load_Glyph(m_face, glyph, FT_LOAD_NO_HINTING | FT_LOAD_RENDER), 0);
            const Result<GlyphBitmap> bitmap =
                m_font->bitmap(static_cast<std::uint16_t>(glyph), static_cast<float>(pixels));
            ASSERT_TRUE(bitmap) << toString(bitmap.error());
            compare(*bitmap, m_face->glyph, difference);
        }
    }
    EXPECT_LE(difference.largest, 36);
    EXPECT_LE(difference.sum / difference.pixels, 0.5);
    RecordProperty("largest", difference.largest);
    RecordProperty("mean", std::to_string(difference.sum / difference.pixels));
}

} // namespace
} // namespace franken::test
