// SPDX-License-Identifier: MIT
// Fonts: what their tables say, glyphs as pixels, and lines of text.
#include "franken/font.h"
#include "franken/text_layout.h"
#include "support/font_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace franken::test {
namespace {

Font fontOf(const FontFile& file) {
    Result<Font> font = parseFont(file.bytes());
    EXPECT_TRUE(font) << toString(font.error());
    return *std::move(font);
}

GlyphBitmap bitmapOf(const Font& font, std::uint16_t glyph, float pixels) {
    Result<GlyphBitmap> bitmap = font.bitmap(glyph, pixels);
    EXPECT_TRUE(bitmap) << toString(bitmap.error());
    return *std::move(bitmap);
}

/// In pixels.
double areaOf(const GlyphBitmap& bitmap) {
    return std::accumulate(bitmap.coverage.begin(), bitmap.coverage.end(), 0.0) / 255;
}

TEST(Font, SaysWhatItsTablesSay) {
    const Font font = fontOf(soundFont());
    EXPECT_FLOAT_EQ(font.ascent(), 0.8f);
    EXPECT_FLOAT_EQ(font.descent(), 0.2f);
    EXPECT_FLOAT_EQ(font.lineGap(), 0.1f);
    EXPECT_EQ(font.glyphOf('A'), SquareA);
    EXPECT_EQ(font.glyphOf(' '), Space);
    EXPECT_EQ(font.glyphOf(0x1F600), SquareA);
    for (const char32_t code :
         {U'\0', U'@', U'C', U'z', char32_t{0x1F601}, char32_t{0x110000}, char32_t{0xFFFFFFFF}})
        EXPECT_EQ(font.glyphOf(code), Missing) << static_cast<unsigned>(code);
    EXPECT_FLOAT_EQ(font.advance(Space), 0.5f);
    EXPECT_FLOAT_EQ(font.advance(SquareA), 1);
    EXPECT_FLOAT_EQ(font.advance(RoundO), 1) << "glyphs beyond the table have the last one's";
    EXPECT_FLOAT_EQ(font.advance(kSoundGlyphs), 0);
    EXPECT_EQ(font, Font(font));
    EXPECT_NE(font, fontOf(soundFont()));
}

TEST(Font, KnowsMapsOfSegments) {
    FontFile file = soundFont();
    file.tables["cmap"] = segmentMap();
    const Font font = fontOf(file);
    EXPECT_EQ(font.glyphOf('A'), SquareA) << "listed";
    EXPECT_EQ(font.glyphOf('B'), HalvesB);
    EXPECT_EQ(font.glyphOf('V'), TriangleV);
    EXPECT_EQ(font.glyphOf('o'), RoundO);
    EXPECT_EQ(font.glyphOf(' '), Space);
    for (const char32_t code : {U'C', U'U', U'p', char32_t{0xFFFF}, char32_t{0x1F600}})
        EXPECT_EQ(font.glyphOf(code), Missing);
}

TEST(Font, KernsByTheTableKernAndRatherByPairPositioning) {
    FontFile file = soundFont();
    const Font old = fontOf(file);
    EXPECT_FLOAT_EQ(old.kerning(SquareA, TriangleV), -0.15f);
    EXPECT_FLOAT_EQ(old.kerning(SquareA, SquareA), 0);
    file.tables["GPOS"] = pairPositioning();
    const Font font = fontOf(file);
    EXPECT_FLOAT_EQ(font.kerning(SquareA, TriangleV), -0.2f) << "format 1";
    EXPECT_FLOAT_EQ(font.kerning(SquareA, RoundO), -0.1f) << "the second of a list";
    EXPECT_FLOAT_EQ(font.kerning(TriangleV, SquareA), -0.3f) << "format 2, behind an extension";
    EXPECT_FLOAT_EQ(font.kerning(TriangleV, HalvesB), -0.3f);
    EXPECT_FLOAT_EQ(font.kerning(TriangleV, RoundO), 0);
    EXPECT_FLOAT_EQ(font.kerning(RoundO, TriangleV), 0);
}

// Least distances and kerning across the line are none.
TEST(Font, KernsByTheTableKernAlongTheLineAlone) {
    for (const int coverage : {0, 3, 5, 0x0201}) {
        FontFile file = soundFont();
        file.tables["kern"].replace(8, 2, u16({coverage}));
        EXPECT_EQ(fontOf(file).kerning(SquareA, TriangleV), 0) << coverage;
    }
}

// At 100 pixels, a unit is a tenth of one: squares are exact, and areas of curves are known.
TEST(Font, CoversWhatItsOutlinesEnclose) {
    const Font font = fontOf(soundFont());
    const GlyphBitmap square = bitmapOf(font, SquareA, 100);
    EXPECT_EQ(square.left, 10);
    EXPECT_EQ(square.top, -80);
    EXPECT_EQ(square.width, 80);
    EXPECT_EQ(square.height, 80);
    EXPECT_TRUE(
        std::all_of(square.coverage.begin(), square.coverage.end(), [](int code) { return code == 255; }));
    EXPECT_NEAR(areaOf(bitmapOf(font, TriangleV, 100)), 100 * 80 / 2.0, 8);
    const GlyphBitmap round = bitmapOf(font, RoundO, 100);
    EXPECT_NEAR(areaOf(round), 60 * 60 * 5 / 6.0, 6)
        << "each corner of a square loses a 24th to its parabola";
    EXPECT_EQ(round.coverage[0], 0);
    EXPECT_EQ(round.coverage[30 * 60 + 30], 255);
    EXPECT_EQ(bitmapOf(font, Space, 100).width, 0);
}

TEST(Font, CountsPartsOfPixels) {
    const Font font = fontOf(soundFont());
    const GlyphBitmap square = bitmapOf(font, SquareA, 5); // From 0.5 to 4.5, 4 high.
    ASSERT_EQ(square.width, 5);
    ASSERT_EQ(square.height, 4);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 5; ++x)
            EXPECT_NEAR(square.coverage[static_cast<std::size_t>(5 * y + x)], x == 0 || x == 4 ? 127.5 : 255,
                        1);
}

TEST(Font, PutsPartsOfCompositesWhereTheyBelong) {
    const GlyphBitmap halves = bitmapOf(fontOf(soundFont()), HalvesB, 100);
    ASSERT_EQ(halves.left, 5);
    ASSERT_EQ(halves.top, -80);
    ASSERT_EQ(halves.width, 90);
    ASSERT_EQ(halves.height, 80);
    const auto at = [&](int x, int y) { return int{halves.coverage[static_cast<std::size_t>(90 * y + x)]}; };
    EXPECT_EQ(at(0, 40), 255) << "the lower one's corners";
    EXPECT_EQ(at(39, 79), 255);
    EXPECT_EQ(at(40, 40), 0);
    EXPECT_EQ(at(0, 39), 0);
    EXPECT_EQ(at(50, 0), 255) << "the upper one's";
    EXPECT_EQ(at(89, 39), 255);
    EXPECT_NEAR(areaOf(halves), 2 * 40 * 40, 1);
}

GlyphBitmap bitmapOfComposite(const std::string& parts) {
    FontFile file = soundFont();
    std::vector<std::string> glyphs = soundGlyphs();
    glyphs[HalvesB] = composite(parts);
    file.setGlyphs(glyphs);
    return bitmapOf(fontOf(file), HalvesB, 100);
}

TEST(Font, PutsPartsByScaledOffsetsAndByPoints) {
    const GlyphBitmap scaled = bitmapOfComposite(scaledHalfPart(SquareA, 1000, 800));
    EXPECT_EQ(scaled.left, 55);
    EXPECT_EQ(scaled.top, -80);
    const GlyphBitmap hung =
        bitmapOfComposite(halfPart(SquareA, 100, 400, true) + hungHalfPart(SquareA, 3, 0));
    EXPECT_EQ(hung.left, 15);
    EXPECT_EQ(hung.top, -80);
    EXPECT_EQ(hung.width, 80) << "the lower right corner of one is the lower left one of the other";
    EXPECT_EQ(hung.height, 40);
}

TEST(Font, ScalesAndTurnsParts) {
    constexpr int kWordsAndOffsets = 3, kTwoScales = 64, kMatrix = 128, kOne = 16384;
    const GlyphBitmap scaled =
        bitmapOfComposite(u16({kWordsAndOffsets | kTwoScales, SquareA, 0, 0, kOne / 2, kOne / 4}));
    EXPECT_EQ(scaled.left, 5);
    EXPECT_EQ(scaled.width, 40);
    EXPECT_EQ(scaled.height, 20);
    const GlyphBitmap turned =
        bitmapOfComposite(u16({kWordsAndOffsets | kMatrix, TriangleV, 0, 0, 0, kOne, -kOne, 0}));
    EXPECT_EQ(turned.left, -80) << "x becomes y, and y becomes -x";
    EXPECT_EQ(turned.width, 80);
    EXPECT_EQ(turned.top, -100);
    EXPECT_EQ(turned.height, 100);
}

TEST(Font, AGlyphWithoutContoursIsEmptyThoughItHasBytes) {
    FontFile file = soundFont();
    std::vector<std::string> glyphs = soundGlyphs();
    glyphs[SquareA] = u16({0, 0, 0, 0, 0});
    file.setGlyphs(glyphs);
    EXPECT_EQ(bitmapOf(fontOf(file), SquareA, 100).width, 0);
}

TEST(Font, ShowsABoxForWhatIsMissingWhereTheFontShowsNothing) {
    const Font font = fontOf(soundFont());
    const GlyphBitmap box = bitmapOf(font, Missing, 100);
    EXPECT_EQ(box.width, 40);
    EXPECT_EQ(box.height, 70);
    EXPECT_EQ(box.coverage[0], 255);
    EXPECT_EQ(box.coverage[35 * 40 + 20], 0) << "hollow";
    EXPECT_FLOAT_EQ(font.advance(Missing), 0.5f);
}

class TextLayoutTest : public testing::Test {
protected:
    const TextLayout& of(std::string_view text, const TextStyle& style = {.pixels = 100}) {
        layOut(m_font, text, style, m_layout);
        return m_layout;
    }
    std::vector<float> xs(std::string_view text, const TextStyle& style = {.pixels = 100}) {
        std::vector<float> result;
        for (const PlacedGlyph& glyph : of(text, style).glyphs)
            result.push_back(glyph.x);
        return result;
    }
    std::vector<std::size_t> lineLengths(std::string_view text, float width) {
        std::vector<std::size_t> result;
        for (const TextLayout::Line& line : of(text, {.pixels = 100, .width = width}).lines)
            result.push_back(line.end - line.first);
        return result;
    }

    Font m_font = fontOf(soundFont());
    TextLayout m_layout;
};

using Floats = std::vector<float>;
using Sizes = std::vector<std::size_t>;

TEST_F(TextLayoutTest, AddsAdvancesAndKerning) {
    EXPECT_EQ(xs("AAV A"), Floats({0, 100, 185, 335}));
    EXPECT_EQ(m_layout.width, 435);
    EXPECT_EQ(m_layout.height, 110);
    EXPECT_EQ(m_layout.glyphs[0].y, 80) << "the baseline";
    EXPECT_EQ(xs("A\tA"), Floats({0, 300})) << "a tab is four spaces";
}

TEST_F(TextLayoutTest, RoundsPensAndAddsWhatIsNotRounded) {
    EXPECT_EQ(xs("AAAA", {.pixels = 10.4f}), Floats({0, 10, 21, 31}));
}

TEST_F(TextLayoutTest, EndsLinesAtLineFeeds) {
    of("A\r\nVV\n\nA");
    ASSERT_EQ(m_layout.lines.size(), 4u);
    EXPECT_EQ(m_layout.height, 440);
    EXPECT_EQ(m_layout.width, 200);
    EXPECT_EQ(m_layout.glyphs[1].y, 190);
    EXPECT_EQ(m_layout.glyphs[3].y, 410);
    EXPECT_EQ(of("").lines.size(), 1u);
    EXPECT_EQ(m_layout.height, 110);
    EXPECT_EQ(m_layout.width, 0);
}

TEST_F(TextLayoutTest, WrapsAtSpacesAndInLongWords) {
    EXPECT_EQ(lineLengths("AA AA AA", 250), Sizes({2, 2, 2}));
    EXPECT_EQ(m_layout.glyphs[2].x, 0);
    EXPECT_EQ(m_layout.glyphs[2].y, 190);
    EXPECT_EQ(lineLengths("AA AA AA", 449), Sizes({2, 2, 2}));
    EXPECT_EQ(lineLengths("AA AA AA", 450), Sizes({4, 2}));
    EXPECT_EQ(lineLengths("AAAAA", 250), Sizes({2, 2, 1})) << "a word that is longer than a line";
    EXPECT_EQ(lineLengths("A AAAAA", 250), Sizes({1, 2, 2, 1}));
    EXPECT_EQ(lineLengths("AAA", 1), Sizes({1, 1, 1})) << "a glyph a line at least";
    EXPECT_EQ(lineLengths("AA      AA", 250), Sizes({2, 2})) << "spaces at the end have room";
    EXPECT_EQ(m_layout.lines[0].width, 200);
    EXPECT_EQ(lineLengths("AA\xC2\xA0"
                          "AA",
                          330),
              Sizes({3, 2}))
        << "no break at U+00A0";
}

TEST_F(TextLayoutTest, AlignsLines) {
    const auto aligned = [&](TextAlign align, float width) {
        return xs("AAA \nA", {.pixels = 100, .width = width, .align = align});
    };
    EXPECT_EQ(aligned(TextAlign::Left, 0), Floats({0, 100, 200, 0}));
    EXPECT_EQ(aligned(TextAlign::Center, 0), Floats({0, 100, 200, 100})) << "in the widest line";
    EXPECT_EQ(aligned(TextAlign::Right, 0), Floats({0, 100, 200, 200}));
    EXPECT_EQ(aligned(TextAlign::Center, 500), Floats({100, 200, 300, 200}));
    EXPECT_EQ(aligned(TextAlign::Right, 500), Floats({200, 300, 400, 400}));
    EXPECT_EQ(m_layout.width, 500);
}

TEST_F(TextLayoutTest, ReadsUtf8) {
    const auto codes = [&](std::string_view text) {
        std::u32string result;
        for (const PlacedGlyph& glyph : of(text).glyphs)
            result += glyph.code;
        return result;
    };
    EXPECT_EQ(codes("A\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80"), U"A\u00E9\u20AC\U0001F600");
    EXPECT_EQ(codes("A\xFFV\xC3"), U"A\uFFFDV\uFFFD") << "bytes that are none";
    EXPECT_EQ(codes("\xED\xA0\x80"), U"\uFFFD\uFFFD\uFFFD") << "a surrogate";
    EXPECT_EQ(codes("A\x01\xE2\x80\x8E\xEF\xBB\xBFV"), U"AV") << "what is not seen";
    EXPECT_EQ(m_layout.glyphs[1].x, 85) << "they do not come between neighbours";
}

TEST_F(TextLayoutTest, ClampsNumbersThatAreNone) {
    for (const float bad : {NAN, -INFINITY, INFINITY, -1.0f, 0.0f})
        for (const TextStyle& style :
             {TextStyle{.pixels = bad}, {.pixels = 9, .width = bad}, {.pixels = 9, .lineSpacing = bad}}) {
            of("AA V\nA", style);
            EXPECT_TRUE(std::isfinite(m_layout.width) && std::isfinite(m_layout.height));
            EXPECT_EQ(m_layout.glyphs.size(), 4u);
        }
}

} // namespace
} // namespace franken::test
