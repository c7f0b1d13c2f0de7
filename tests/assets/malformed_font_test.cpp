// SPDX-License-Identifier: MIT
// Fonts that are broken, greedy or hostile.
#include "franken/font.h"
#include "support/font_builder.h"
#include "support/font_walk.h"
#include "support/shell.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <random>
#include <set>

namespace franken::test {
namespace {

using Change = std::function<void(FontFile&)>;

/// What is wrong with a font, and the code that refuses it.
struct Row {
    const char* name;
    Change change;
    const char* code;
};

void put16(std::string& table, std::size_t at, int value) { table.replace(at, 2, u16({value})); }
void put32(std::string& table, std::size_t at, std::uint32_t value) { table.replace(at, 4, u32({value})); }

/// Another number in a table.
Change number(const char* table, std::size_t at, int value) {
    return [=](FontFile& font) { put16(font.tables[table], at, value); };
}
Change without(const char* table) {
    return [=](FontFile& font) { font.tables.erase(table); };
}
Change cutTo(const char* table, std::size_t bytes) {
    return [=](FontFile& font) { font.tables[table].resize(bytes); };
}
Change format(std::uint32_t value) {
    return [=](FontFile& font) { font.format = value; };
}
Change segments(std::size_t at, int value) {
    return [=](FontFile& font) { put16(font.tables["cmap"] = segmentMap(), at, value); };
}

constexpr std::size_t kMap = 12; ///< Where cmap's one encoding begins.

const std::vector<Row> kRefused = {
    {"no TrueType", format(0x12345678), "font.format"},
    {"PostScript outlines", format(0x4F54544F), "font.unsupported"},
    {"a collection", format(0x74746366), "font.unsupported"},
    {"WOFF", format(0x774F4646), "font.unsupported"},
    {"WOFF 2", format(0x774F4632), "font.unsupported"},
    {"Type 1", format(0x74797031), "font.unsupported"},
    {"no cmap", without("cmap"), "font.unsupported"},
    {"no glyf", without("glyf"), "font.format"},
    {"no outlines at all",
     [](FontFile& font) {
         font.tables.erase("glyf");
         font.tables.erase("loca");
     },
     "font.unsupported"},
    {"no head", without("head"), "font.format"},
    {"no hhea", without("hhea"), "font.format"},
    {"no hmtx", without("hmtx"), "font.format"},
    {"no loca", without("loca"), "font.format"},
    {"no maxp", without("maxp"), "font.format"},
    {"head cut off", cutTo("head", 53), "font.format"},
    {"head's magic number", number("head", 12, 0), "font.format"},
    {"0 units per em", number("head", 18, 0), "font.format"},
    {"15 units per em", number("head", 18, 15), "font.format"},
    {"16385 units per em", number("head", 18, 16385), "font.format"},
    {"an unknown format of offsets", number("head", 50, 2), "font.format"},
    {"a negative format of offsets", number("head", 50, -1), "font.format"},
    {"no glyphs", number("maxp", 4, 0), "font.format"},
    {"more glyphs than loca has", number("maxp", 4, kSoundGlyphs + 1), "font.format"},
    {"65535 glyphs", number("maxp", 4, 65535), "font.format"},
    {"hhea cut off", cutTo("hhea", 35), "font.format"},
    {"lines without height", number("hhea", 4, -200), "font.format"},
    {"lines of negative height", number("hhea", 6, 900), "font.format"},
    {"no widths", number("hhea", 34, 0), "font.format"},
    {"more widths than glyphs", number("hhea", 34, kSoundGlyphs + 1), "font.format"},
    {"hmtx cut off", cutTo("hmtx", 11), "font.format"},
    {"loca cut off", cutTo("loca", 4 * kSoundGlyphs), "font.format"},
    {"loca decreases", [](FontFile& font) { put32(font.tables["loca"], 8, 100); }, "font.format"},
    {"loca leads out of glyf",
     [](FontFile& font) { put32(font.tables["loca"], 4 * kSoundGlyphs, 0x7FFFFFFF); }, "font.format"},
    {"loca's largest offset",
     [](FontFile& font) { put32(font.tables["loca"], 4 * kSoundGlyphs, 0xFFFFFFFF); }, "font.format"},
    {"glyf cut off", cutTo("glyf", 40), "font.format"},
    {"no encodings", number("cmap", 2, 0), "font.unsupported"},
    {"an encoding of symbols", number("cmap", 6, 0), "font.unsupported"},
    {"an encoding outside", [](FontFile& font) { put32(font.tables["cmap"], 8, 0xFFFFFFF0); },
     "font.unsupported"},
    {"a map of format 6", number("cmap", kMap, 6), "font.unsupported"},
    {"more groups than there are", [](FontFile& font) { put32(font.tables["cmap"], kMap + 12, 7); },
     "font.format"},
    {"2^32 - 1 groups", [](FontFile& font) { put32(font.tables["cmap"], kMap + 12, 0xFFFFFFFF); },
     "font.format"},
    {"groups out of order", [](FontFile& font) { put32(font.tables["cmap"], kMap + 16, 'B'); },
     "font.format"},
    {"a group that ends before it begins", [](FontFile& font) { put32(font.tables["cmap"], kMap + 20, 1); },
     "font.format"},
    {"a group beyond Unicode",
     [](FontFile& font) { put32(font.tables["cmap"], kMap + 16 + 5 * 12 + 4, 0x110000); }, "font.format"},
    {"no segments", segments(kMap + 6, 0), "font.format"},
    {"more segments than there are", segments(kMap + 6, 0xFFFE), "font.format"},
    {"segments whose offsets to lists are cut off",
     [](FontFile& font) {
         font.tables["cmap"] = segmentMap();
         font.tables["cmap"].resize(kMap + 16 + 8 * 5 - 2);
     },
     "font.format"},
    {"segments out of order", segments(kMap + 14, 'V'), "font.format"},
    {"a segment that ends before it begins", segments(kMap + 14, 1), "font.format"},
};

TEST(MalformedFonts, AreRefusedWithWhatToDo) {
    std::set<std::string> names;
    for (const Row& row : kRefused) {
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        FontFile file = soundFont();
        row.change(file);
        const Result<Font> font = parseFont(file.bytes());
        EXPECT_FALSE(font) << row.name;
        if (font)
            continue;
        EXPECT_EQ(font.error().code, row.code) << row.name;
        EXPECT_EQ(brokenPromiseOf(file.bytes()), "") << row.name;
    }
}

TEST(MalformedFonts, ListsOfTablesAreChecked) {
    const std::vector<std::uint8_t> sound = soundFont().bytes();
    const auto codeOf = [](const std::vector<std::uint8_t>& bytes) { return parseFont(bytes).error().code; };
    for (const std::size_t length : {0u, 1u, 3u, 4u, 11u, 12u, 27u, 28u, 100u})
        EXPECT_EQ(codeOf({sound.begin(), sound.begin() + static_cast<std::ptrdiff_t>(length)}), "font.format")
            << length;
    std::vector<std::uint8_t> changed = sound;
    changed[4] = 0xFF;
    EXPECT_EQ(codeOf(changed), "font.format") << "more tables than there are";
    changed = sound;
    changed[12 + 8] = 0xFF;
    EXPECT_EQ(codeOf(changed), "font.format") << "a table that begins outside";
    changed = sound;
    changed[12 + 12] = 0xFF;
    EXPECT_EQ(codeOf(changed), "font.format") << "a table that ends outside";
    changed = sound;
    std::copy_n(sound.begin() + 12, 4, changed.begin() + 28);
    EXPECT_EQ(codeOf(changed), "font.format") << "two tables of one name";
    EXPECT_EQ(parseFont(sound, sound.size() - 1).error().code, "font.limit");
    EXPECT_TRUE(parseFont(sound, sound.size()));
}

/// An outline that is broken, in the glyph of 'A'.
struct GlyphRow {
    const char* name;
    std::string glyph;
};

/// Of 29 bytes. What is cut off is 0 in the file up to its next multiple of 4, so that cuts end at one.
std::string cutGlyph(std::size_t bytes) {
    return contours({{{0, 0}, {0, 800}, {800, 800}}}).substr(0, bytes);
}

std::string chain(std::size_t parts) {
    std::string all;
    for (std::size_t i = 0; i < parts; ++i)
        all += halfPart(Space, 0, 0, i + 1 < parts);
    return composite(all);
}

std::vector<GlyphRow> brokenGlyphs() {
    std::string disordered = contours({{{0, 0}, {0, 8}, {8, 8}}, {{0, 0}, {0, 8}, {8, 8}}});
    put16(disordered, 12, 1);
    std::string hints = contours({{{0, 0}, {0, 8}, {8, 8}}});
    put16(hints, 12, 5000);
    std::string repeated = contours({{{0, 0}, {0, 8}, {8, 8}}});
    repeated.replace(14, 2, "\x09\xFF");
    std::string manyPoints = contours({{{0, 0}, {0, 8}, {8, 8}}});
    put16(manyPoints, 10, 65535);
    std::string anchored = composite(u16({0, SquareA, 0x0901}));
    return {{"cut off in its header", cutGlyph(4)},
            {"cut off in its contours", cutGlyph(8)},
            {"cut off in its flags", cutGlyph(16)},
            {"cut off in its points", cutGlyph(24)},
            {"contours that go back", disordered},
            {"more hints than there are", hints},
            {"flags that repeat beyond the points", repeated},
            {"65536 points", manyPoints},
            {"a part of itself", composite(halfPart(SquareA, 0, 0, false))},
            {"a part that is not there", composite(halfPart(kSoundGlyphs, 0, 0, false))},
            {"65535 as a part", composite(halfPart(0xFFFF, 0, 0, false))},
            {"a part without an end", composite(halfPart(Space, 0, 0, true))},
            {"too many parts", chain(300)},
            {"a part hung on a point that is not there", anchored}};
}

TEST(MalformedFonts, ABrokenGlyphCostsThatGlyph) {
    for (const GlyphRow& row : brokenGlyphs()) {
        FontFile file = soundFont();
        std::vector<std::string> glyphs = soundGlyphs();
        glyphs[SquareA] = row.glyph;
        file.setGlyphs(glyphs);
        const Result<Font> font = parseFont(file.bytes());
        ASSERT_TRUE(font) << row.name << ": " << toString(font.error());
        const Result<GlyphBitmap> bitmap = font->bitmap(SquareA, 20);
        EXPECT_FALSE(bitmap) << row.name;
        if (!bitmap) {
            EXPECT_EQ(bitmap.error().code, "font.glyph") << row.name;
        }
        EXPECT_TRUE(font->bitmap(TriangleV, 20)) << row.name;
        EXPECT_EQ(brokenPromiseOf(file.bytes()), "") << row.name;
        glyphs[Missing] = glyphs[SquareA];
        file.setGlyphs(glyphs);
        EXPECT_EQ(brokenPromiseOf(file.bytes()), "") << row.name << ", as the missing glyph";
    }
}

TEST(MalformedFonts, PartsWithinLimitsAreNotRefused) {
    FontFile file = soundFont();
    std::vector<std::string> glyphs = soundGlyphs();
    glyphs[SquareA] = chain(200);
    file.setGlyphs(glyphs);
    EXPECT_TRUE(parseFont(file.bytes())->bitmap(SquareA, 20));
}

// Each level doubles what is below: a small file could ask for any number of points.
TEST(MalformedFonts, PartsOfPartsAreCountedTogether) {
    FontFile file = soundFont();
    std::vector<std::string> glyphs = soundGlyphs();
    const auto twice = [](int glyph) {
        return composite(halfPart(glyph, 0, 0, true) + halfPart(glyph, 0, 0, false));
    };
    for (int level = 0; level < 40; ++level)
        glyphs.push_back(twice(level == 0 ? int{TriangleV} : kSoundGlyphs + level - 1));
    file.setGlyphs(glyphs);
    put16(file.tables["maxp"], 4, static_cast<int>(glyphs.size()));
    const Result<Font> font = parseFont(file.bytes());
    ASSERT_TRUE(font) << toString(font.error());
    EXPECT_TRUE(font->bitmap(kSoundGlyphs + 6, 20)) << "2^7 parts, 7 deep";
    for (const int level : {7, 8, 39})
        EXPECT_EQ(font->bitmap(static_cast<std::uint16_t>(kSoundGlyphs + level), 20).error().code,
                  "font.glyph");
}

TEST(MalformedFonts, OutlinesOfExtremeSizeAreRefusedOrDrawn) {
    FontFile file = soundFont();
    std::vector<std::string> glyphs = soundGlyphs();
    glyphs[SquareA] = contours({{{-16000, -16000}, {-16000, 16000}, {16000, 16000}, {16000, -16000}}});
    glyphs[RoundO] = contours({{{5, 5, false}}, {{0, 0, false}, {9, 9, false}}, {{7, 7}}});
    file.setGlyphs(glyphs);
    const Font font = *parseFont(file.bytes());
    EXPECT_EQ(font.bitmap(SquareA, 100).error().code, "font.size");
    EXPECT_TRUE(font.bitmap(SquareA, 5));
    EXPECT_TRUE(font.bitmap(RoundO, 100)) << "contours of one and two points";
}

// Kerning that is broken kerns nothing, or by what is left; the font is drawn.
TEST(MalformedFonts, BrokenKerningIsNone) {
    for (const char* table : {"kern", "GPOS"}) {
        FontFile sound = soundFont();
        sound.tables["GPOS"] = pairPositioning();
        if (std::string_view(table) == "kern")
            sound.tables.erase("GPOS");
        const std::string before = sound.tables[table];
        for (std::size_t length = 0; length < before.size(); ++length) {
            sound.tables[table] = before.substr(0, length);
            EXPECT_EQ(brokenPromiseOf(sound.bytes()), "") << table << " of " << length << " bytes";
        }
        for (std::size_t at = 0; at + 1 < before.size(); at += 2)
            for (const int value : {0, 1, 0x7FFF, 0xFFFF}) {
                sound.tables[table] = before;
                put16(sound.tables[table], at, value);
                EXPECT_EQ(brokenPromiseOf(sound.bytes()), "") << table << " at " << at << ": " << value;
            }
    }
}

TEST(MalformedFonts, AnyChangeOfBytesIsSurvived) {
    std::mt19937 random(7);
    FontFile variants[2] = {soundFont(), soundFont()};
    variants[0].tables["GPOS"] = pairPositioning();
    variants[1].tables["cmap"] = segmentMap();
    variants[1].setGlyphs(soundGlyphs(), false);
    put16(variants[1].tables["head"], 50, 0);
    int refused = 0;
    constexpr int kRounds = 6000;
    for (int round = 0; round < kRounds; ++round) {
        std::vector<std::uint8_t> bytes = variants[round % 2].bytes();
        for (unsigned changes = 1 + random() % 4; changes > 0; --changes)
            bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random() % 3 == 0 ? 0xFF : random());
        if (random() % 8 == 0)
            bytes.resize(random() % bytes.size());
        EXPECT_EQ(brokenPromiseOf(bytes), "") << "round " << round;
        refused += !parseFont(bytes);
    }
    EXPECT_GT(refused, kRounds / 20);
    EXPECT_LT(refused, kRounds * 19 / 20) << "most are read on";
}

TEST(FontFiles, AreReadFromFilesWithTheirNamesInErrors) {
    const std::filesystem::path folder = emptyTestFolder();
    const auto write = [&](const char* name, const std::vector<std::uint8_t>& bytes) {
        std::ofstream(folder / name, std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        return folder / name;
    };
    const std::vector<std::uint8_t> sound = soundFont().bytes();
    EXPECT_TRUE(loadFont(write("sound.ttf", sound)));
    EXPECT_EQ(loadFont(folder / "sound.ttf", 10).error().code, "file.size");
    EXPECT_EQ(loadFont(folder / "none.ttf").error().code, "file.open");
    EXPECT_EQ(loadFont(folder).error().code, "file.open");
    const Error broken = loadFont(write("broken.ttf", {1, 2, 3})).error();
    EXPECT_EQ(broken.code, "font.format");
    EXPECT_TRUE(broken.where.ends_with("broken.ttf")) << broken.where;
}

} // namespace
} // namespace franken::test
