// SPDX-License-Identifier: MIT
#include "font/tables.h"

#include <algorithm>
#include <array>
#include <string>

namespace franken {
namespace {

constexpr std::uint32_t tag(const char (&name)[5]) {
    std::uint32_t value = 0;
    for (int i = 0; i < 4; ++i)
        value = value << 8U | static_cast<std::uint8_t>(name[i]);
    return value;
}

constexpr std::uint32_t kTrueType = 0x00010000, kTrueTypeOfApple = tag("true");
constexpr std::size_t kHeader = 12, kRecord = 16;

struct OtherFormat {
    std::uint32_t tag;
    const char *what, *remedy;
};

constexpr std::array<OtherFormat, 5> kOtherFormats = {{
    {tag("OTTO"), "an OpenType font with PostScript outlines (CFF)",
     "convert it to TrueType outlines (.ttf)"},
    {tag("ttcf"), "a collection of several fonts", "extract one of them as a .ttf"},
    {tag("wOFF"), "a font packed for the web (WOFF)", "unpack it to a .ttf"},
    {tag("wOF2"), "a font packed for the web (WOFF2)", "unpack it to a .ttf"},
    {tag("typ1"), "a Type 1 font", "convert it to TrueType outlines (.ttf)"},
}};

Result<void> checkFormat(const FontTable& file) {
    const std::uint32_t format = file.u32(0);
    for (const OtherFormat& other : kOtherFormats)
        if (format == other.tag)
            return Error{"font.unsupported", "", std::string("the file is ") + other.what, other.remedy};
    if (format != kTrueType && format != kTrueTypeOfApple)
        return fontError("", "it does not begin as a TrueType file does");
    return {};
}

/// Finds tables by name.
class Directory {
public:
    static Result<Directory> of(FontTable file) {
        const std::size_t count = file.u16(4);
        if (count == 0 || !file.has(kHeader, count * kRecord))
            return fontError("", "its list of tables is cut off");
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t at = kHeader + i * kRecord;
            if (!file.has(file.u32(at + 8), file.u32(at + 12)))
                return fontError("", "a table reaches beyond the end of the file");
            for (std::size_t earlier = 0; earlier < std::min<std::size_t>(i, kMaxTables); ++earlier)
                if (file.u32(at) == file.u32(kHeader + earlier * kRecord))
                    return fontError("", "it has a table twice");
            if (i >= kMaxTables)
                return fontError("", "it has more tables than there are kinds");
        }
        return Directory(file, count);
    }

    /// Empty where there is none.
    FontTable find(std::uint32_t name) const {
        for (std::size_t at = kHeader; at < kHeader + m_count * kRecord; at += kRecord)
            if (m_file.u32(at) == name)
                return m_file.part(m_file.u32(at + 8), m_file.u32(at + 12));
        return {};
    }

private:
    static constexpr std::size_t kMaxTables = 256;
    Directory(FontTable file, std::size_t count) : m_file(file), m_count(count) {}

    FontTable m_file;
    std::size_t m_count;
};

/// Whether the offsets of loca have 32 bits; else they are halves, of 16 bits.
Result<bool> readHead(const FontTable& head, FontTables& tables) {
    constexpr std::uint32_t kMagic = 0x5F0F3CF5;
    if (!head.has(0, 54) || head.u32(12) != kMagic)
        return fontError("head", "it is missing or broken");
    tables.unitsPerEm = head.u16(18);
    if (tables.unitsPerEm < 16 || tables.unitsPerEm > 16384)
        return fontError("head", std::to_string(tables.unitsPerEm) + " units per em are not 16 to 16384");
    if (head.u16(50) > 1)
        return fontError("head", "the format of glyph offsets is unknown");
    return head.u16(50) == 1;
}

Result<void> readMetrics(const FontTable& profile, const FontTable& header, FontTables& tables) {
    tables.glyphs = profile.u16(4);
    if (tables.glyphs < 1)
        return fontError("maxp", "there are no glyphs");
    if (!header.has(0, 36))
        return fontError("hhea", "it is missing or cut off");
    tables.ascent = header.s16(4);
    tables.descent = header.s16(6);
    tables.lineGap = std::max<int>(header.s16(8), 0);
    tables.horizontalMetricsCount = header.u16(34);
    if (tables.ascent - tables.descent <= 0)
        return fontError("hhea", "a line has no height");
    if (tables.horizontalMetricsCount < 1 || tables.horizontalMetricsCount > tables.glyphs)
        return fontError("hhea", "its number of widths is not 1 to the number of glyphs");
    if (!tables.horizontalMetrics.has(0, 4 * static_cast<std::size_t>(tables.horizontalMetricsCount)))
        return fontError("hmtx", "it is missing or cut off");
    return {};
}

Result<void> readGlyphOffsets(const FontTable& locations, bool isLong, FontTables& tables) {
    const std::size_t count = static_cast<std::size_t>(tables.glyphs) + 1;
    if (!locations.has(0, count * (isLong ? 4 : 2)))
        return fontError("loca", "it is missing or cut off");
    tables.glyphOffsets.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        tables.glyphOffsets.push_back(isLong ? locations.u32(4 * i) : 2U * locations.u16(2 * i));
    if (!std::is_sorted(tables.glyphOffsets.begin(), tables.glyphOffsets.end()))
        return fontError("loca", "a glyph ends before it begins");
    if (tables.glyphOffsets.back() > tables.outlines.size())
        return fontError("loca", "a glyph lies outside of the outlines (glyf)");
    return {};
}

} // namespace

Error fontError(const char* table, const std::string& what) {
    return {"font.format", table, "the font is broken: " + what, "get it again from where it came from"};
}

Result<FontTables> readFontTables(std::span<const std::uint8_t> bytes) {
    const FontTable file(bytes);
    if (Result<void> checked = checkFormat(file); !checked)
        return checked.error();
    const Result<Directory> directory = Directory::of(file);
    if (!directory)
        return directory.error();
    FontTables tables;
    tables.characters = directory->find(tag("cmap"));
    tables.outlines = directory->find(tag("glyf"));
    tables.kerning = directory->find(tag("kern"));
    tables.positioning = directory->find(tag("GPOS"));
    tables.horizontalMetrics = directory->find(tag("hmtx"));
    const FontTable locations = directory->find(tag("loca"));
    if (tables.outlines.size() == 0 && locations.size() == 0)
        return Error{"font.unsupported", "",
                     "the font has no TrueType outlines (glyf), perhaps pictures alone", "use another font"};
    const Result<bool> isLong = readHead(directory->find(tag("head")), tables);
    if (!isLong)
        return isLong.error();
    Result<void> read = readMetrics(directory->find(tag("maxp")), directory->find(tag("hhea")), tables);
    if (read)
        read = readGlyphOffsets(locations, *isLong, tables);
    if (!read)
        return read.error();
    return tables;
}

} // namespace franken
