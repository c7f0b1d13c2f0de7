// SPDX-License-Identifier: MIT
#include "font/character_map.h"

#include "font/tables.h"

#include <algorithm>

namespace franken {
namespace {

constexpr char32_t kLastCode = 0x10FFFF;
constexpr std::uint16_t kSegments = 4, kGroups = 12; ///< Formats.

/// Characters beyond 16 bits need the second kind: it is preferred.
FontTable findEncoding(const FontTable& table, std::uint16_t format) {
    for (std::size_t i = 0; i < table.u16(2); ++i) {
        const std::size_t at = 4 + 8 * i;
        const std::uint16_t platform = table.u16(at), encoding = table.u16(at + 2);
        const bool isUnicode = platform == 0 || (platform == 3 && (encoding == 1 || encoding == 10));
        const FontTable found = table.from(table.u32(at + 4));
        if (isUnicode && found.u16(0) == format)
            return found;
    }
    return {};
}

} // namespace

void CharacterMap::add(char32_t first, char32_t last, std::uint32_t glyph) {
    if (glyph == 0 || glyph >= m_glyphs || last > kLastCode)
        return;
    last = std::min<char32_t>(last, first + (m_glyphs - 1 - glyph));
    if (!m_ranges.empty()) {
        Range& before = m_ranges.back();
        if (before.last + 1 == first && before.glyph + (first - before.first) == glyph) {
            before.last = last;
            return;
        }
    }
    m_ranges.push_back({first, last, static_cast<std::uint16_t>(glyph)});
}

// Four arrays: last and first characters, what to add to a character, and where glyphs are listed instead.
Result<void> CharacterMap::readSegments(const FontTable& table) {
    const std::size_t segments = table.u16(6) / 2;
    const std::size_t lasts = 14, firsts = lasts + 2 * segments + 2, deltas = firsts + 2 * segments,
                      offsets = deltas + 2 * segments;
    if (segments == 0 || !table.has(0, offsets + 2 * segments))
        return fontError("cmap", "its segments are cut off");
    char32_t next = 0;
    for (std::size_t i = 0; i < segments; ++i) {
        const char32_t first = table.u16(firsts + 2 * i), last = table.u16(lasts + 2 * i);
        if (first > last || first < next)
            return fontError("cmap", "its segments are not in order");
        next = last + 1;
        const std::uint16_t delta = table.u16(deltas + 2 * i), offset = table.u16(offsets + 2 * i);
        for (char32_t code = first; code <= last; ++code) {
            const std::size_t listed = offsets + 2 * i + offset + 2 * (code - first);
            const std::uint32_t glyph = offset == 0 ? code : table.u16(listed);
            if (glyph != 0)
                add(code, code, (glyph + delta) & 0xFFFFU);
        }
    }
    return {};
}

Result<void> CharacterMap::readGroups(const FontTable& table) {
    const std::size_t groups = table.u32(12);
    if (groups > table.size() || !table.has(16, 12 * groups))
        return fontError("cmap", "its groups are cut off");
    char32_t next = 0;
    for (std::size_t i = 0; i < groups; ++i) {
        const std::size_t at = 16 + 12 * i;
        const char32_t first = table.u32(at), last = table.u32(at + 4);
        if (first > last || first < next || last > kLastCode)
            return fontError("cmap", "its groups are not in order");
        next = last + 1;
        add(first, last, table.u32(at + 8));
    }
    return {};
}

Result<CharacterMap> CharacterMap::read(const FontTable& table, int glyphs) {
    CharacterMap map;
    map.m_glyphs = static_cast<std::uint32_t>(glyphs);
    const FontTable groups = findEncoding(table, kGroups), segments = findEncoding(table, kSegments);
    if (groups.size() == 0 && segments.size() == 0)
        return Error{"font.unsupported", "cmap", "the font does not map Unicode's characters to its glyphs",
                     "use another font, or save it with a Unicode map (format 4 or 12)"};
    Result<void> read = groups.size() != 0 ? map.readGroups(groups) : map.readSegments(segments);
    if (!read)
        return read.error();
    return map;
}

std::uint16_t CharacterMap::glyphOf(char32_t code) const {
    const auto after =
        std::upper_bound(m_ranges.begin(), m_ranges.end(), code,
                         [](char32_t wanted, const Range& range) { return wanted < range.first; });
    if (after == m_ranges.begin())
        return 0;
    const Range& range = *std::prev(after);
    return code > range.last ? 0 : static_cast<std::uint16_t>(range.glyph + (code - range.first));
}

} // namespace franken
