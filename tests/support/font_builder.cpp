// SPDX-License-Identifier: MIT
#include "support/font_builder.h"

namespace franken::test {

std::string u16(std::initializer_list<int> values) {
    std::string bytes;
    for (const int value : values) {
        bytes += static_cast<char>(value >> 8 & 0xFF);
        bytes += static_cast<char>(value & 0xFF);
    }
    return bytes;
}

std::string u32(std::initializer_list<std::uint32_t> values) {
    std::string bytes;
    for (const std::uint32_t value : values)
        bytes += u16({static_cast<int>(value >> 16), static_cast<int>(value & 0xFFFF)});
    return bytes;
}

void FontFile::setGlyphs(const std::vector<std::string>& glyphs, bool longOffsets) {
    std::string outlines, offsets;
    const auto addOffset = [&] {
        const std::size_t at = outlines.size();
        offsets += longOffsets ? u32({static_cast<std::uint32_t>(at)}) : u16({static_cast<int>(at / 2)});
    };
    for (const std::string& glyph : glyphs) {
        addOffset();
        outlines += glyph;
        outlines.resize((outlines.size() + 3) / 4 * 4);
    }
    addOffset();
    tables["glyf"] = outlines;
    tables["loca"] = offsets;
}

std::vector<std::uint8_t> FontFile::bytes() const {
    std::string directory = u32({format}) + u16({static_cast<int>(tables.size()), 0, 0, 0}), contents;
    for (const auto& [name, table] : tables) {
        const std::size_t at = 12 + 16 * tables.size() + contents.size();
        directory +=
            name + u32({0, static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(table.size())});
        contents += table;
        contents.resize((contents.size() + 3) / 4 * 4);
    }
    const std::string whole = directory + contents;
    return {whole.begin(), whole.end()};
}

std::string contours(const std::vector<std::vector<FontPoint>>& shapes) {
    std::string glyph = u16({static_cast<int>(shapes.size()), 0, 0, 0, 0}), flags, xs, ys;
    int count = 0, x = 0, y = 0;
    for (const std::vector<FontPoint>& shape : shapes) {
        count += static_cast<int>(shape.size());
        glyph += u16({count - 1});
        for (const FontPoint& point : shape) {
            flags += point.onCurve ? '\1' : '\0';
            xs += u16({point.x - x});
            ys += u16({point.y - y});
            x = point.x;
            y = point.y;
        }
    }
    return glyph + u16({0}) + flags + xs + ys;
}

namespace {

constexpr int kWords = 1, kOffsets = 2, kScale = 8, kMore = 32, kScaledOffset = 2048;

std::string halfPartOf(int flags, int glyph, int first, int second) {
    constexpr int kHalf = 8192;
    return u16({flags | kWords | kScale, glyph, first, second, kHalf});
}

} // namespace

std::string halfPart(int glyph, int x, int y, bool more) {
    return halfPartOf(kOffsets | (more ? kMore : 0), glyph, x, y);
}

std::string scaledHalfPart(int glyph, int x, int y) {
    return halfPartOf(kOffsets | kScaledOffset, glyph, x, y);
}

std::string hungHalfPart(int glyph, int of, int on) { return halfPartOf(0, glyph, of, on); }

std::string composite(const std::string& parts) { return u16({-1, 0, 0, 0, 0}) + parts; }

std::vector<std::string> soundGlyphs() {
    return {"",
            "",
            contours({{{100, 0}, {100, 800}, {900, 800}, {900, 0}}}),
            contours({{{0, 800}, {1000, 800}, {500, 0}}}),
            composite(halfPart(SquareA, 0, 0, true) + halfPart(SquareA, 500, 400, false)),
            contours({{{0, 0, false}, {0, 600, false}, {600, 600, false}, {600, 0, false}}})};
}

namespace {

/// A table cmap of one encoding (Windows, Unicode).
std::string characterMap(int encoding, const std::string& subtable) {
    return u16({0, 1, 3, encoding}) + u32({12}) + subtable;
}

std::string groupMap() {
    const std::string groups = u32({' ', ' ', Space, 'A', 'A', SquareA, 'B', 'B', HalvesB, 'V', 'V',
                                    TriangleV, 'o', 'o', RoundO, 0x1F600, 0x1F600, SquareA});
    return characterMap(10,
                        u16({12, 0}) + u32({static_cast<std::uint32_t>(16 + groups.size()), 0, 6}) + groups);
}

std::string kernTable() {
    return u16({0, 1, 0, 14 + 2 * 6, 1, 2, 0, 0, 0, SquareA, TriangleV, -150, TriangleV, SquareA, -150});
}

} // namespace

// The second segment lists its glyphs, behind the four arrays; the others add to the character.
std::string segmentMap() {
    constexpr int kListed = 2 * 4; // From the second segment's offset to the list.
    return characterMap(1, u16({4, 0, 0, 2 * 5, 0, 0, 0}) + u16({' ', 'B', 'V', 'o', 0xFFFF, 0}) +
                               u16({' ', 'A', 'V', 'o', 0xFFFF}) +
                               u16({Space - ' ', 0, TriangleV - 'V', RoundO - 'o', 1}) +
                               u16({0, kListed, 0, 0, 0}) + u16({SquareA, HalvesB}));
}

std::string pairPositioning() {
    constexpr int kAdvance = 4;
    constexpr int kPlacement = 1; // Of both glyphs of a pair, which does not count.
    const std::string list = u16({1, 12, kPlacement | kAdvance, kPlacement, 1, 18, 1, 1, SquareA, 2}) +
                             u16({TriangleV, 77, -200, 55, RoundO, 77, -100, 55});
    const std::string matrix = u16({2, 16 + 2 * 2 * 2, kAdvance, 0, 30, 40, 2, 2, 0, 0, 0, -300}) +
                               u16({1, 1, TriangleV}) + u16({1, TriangleV, 1, 1, 0}) +
                               u16({2, 2, SquareA, SquareA, 1, HalvesB, HalvesB, 1});
    const std::string first = u16({2, 0, 1, 8}) + list;
    const std::string second = u16({9, 0, 1, 8}) + u16({1, 2}) + u32({8}) + matrix;
    const std::string lookups = u16({2, 6, 6 + static_cast<int>(first.size())}) + first + second;
    const std::string features = u16({1}) + "kern" + u16({8, 0, 2, 0, 1});
    return u16({1, 0, 10, 12, 12 + static_cast<int>(features.size()), 0}) + features + lookups;
}

FontFile soundFont() {
    FontFile font;
    font.setGlyphs(soundGlyphs());
    font.tables["head"] =
        u32({0x00010000, 0, 0, 0x5F0F3CF5}) + u16({0, 1000}) + std::string(30, '\0') + u16({1, 0});
    font.tables["maxp"] = u32({0x00010000}) + u16({kSoundGlyphs});
    font.tables["hhea"] = u32({0x00010000}) + u16({800, -200, 100}) + std::string(24, '\0') + u16({3});
    font.tables["hmtx"] = u16({0, 0, 500, 0, 1000, 100, 0, 0, 0}); // Later ones have only a bearing.
    font.tables["cmap"] = groupMap();
    font.tables["kern"] = kernTable();
    return font;
}

} // namespace franken::test
