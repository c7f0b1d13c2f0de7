// SPDX-License-Identifier: MIT
#include "font/kerning.h"

#include <algorithm>
#include <bit>
#include <optional>
#include <set>

namespace franken {
namespace {

// Offsets may all lead to one place, so that a small file could ask for any amount of work.
constexpr std::size_t kMaxFeatures = 512, kMaxLookupsOfFeature = 64, kMaxSubtables = 64, kMaxLookups = 64,
                      kMaxPairTables = 16;

/// The position of a glyph in a coverage table.
std::optional<std::size_t> coverageIndex(const FontTable& table, std::uint16_t glyph) {
    const bool isList = table.u16(0) == 1;
    if (!isList && table.u16(0) != 2)
        return {};
    std::size_t low = 0, high = table.u16(2);
    while (low < high) {
        const std::size_t middle = (low + high) / 2, at = 4 + (isList ? 2 : 6) * middle;
        const std::uint16_t first = table.u16(at), last = isList ? first : table.u16(at + 2);
        if (glyph < first)
            high = middle;
        else if (glyph > last)
            low = middle + 1;
        else
            return isList ? middle : std::size_t{table.u16(at + 4)} + (glyph - first);
    }
    return {};
}

/// Of a class definition; 0 for glyphs that it does not name.
std::size_t classOf(const FontTable& table, std::uint16_t glyph) {
    if (table.u16(0) == 1) {
        const std::uint16_t first = table.u16(2), count = table.u16(4);
        return glyph >= first && glyph - first < count ? table.u16(6 + 2 * std::size_t(glyph - first)) : 0;
    }
    std::size_t low = 0, high = table.u16(0) == 2 ? table.u16(2) : 0;
    while (low < high) {
        const std::size_t middle = (low + high) / 2, at = 4 + 6 * middle;
        if (glyph < table.u16(at))
            high = middle;
        else if (glyph > table.u16(at + 2))
            low = middle + 1;
        else
            return table.u16(at + 4);
    }
    return 0;
}

/// The values of a pair, of which only the left one's advance is used.
struct PairValues {
    explicit PairValues(const FontTable& subtable) {
        const std::uint16_t left = subtable.u16(4), right = subtable.u16(6);
        constexpr unsigned kPlacements = 3, kAdvance = 4;
        bytes = 2 * static_cast<std::size_t>(std::popcount(left) + std::popcount(right));
        hasAdvance = (left & kAdvance) != 0;
        advanceAt = 2 * static_cast<std::size_t>(std::popcount(left & kPlacements));
    }
    int advance(const FontTable& table, std::size_t at) const {
        return hasAdvance ? table.s16(at + advanceAt) : 0;
    }

    std::size_t bytes, advanceAt;
    bool hasAdvance;
};

/// Format 1: for each left glyph a sorted list of right ones.
std::optional<int> kerningOfPair(const FontTable& subtable, std::size_t index, std::uint16_t right) {
    if (index >= subtable.u16(8))
        return {};
    const PairValues values(subtable);
    const FontTable set = subtable.from(subtable.u16(10 + 2 * index));
    std::size_t low = 0, high = set.u16(0);
    while (low < high) {
        const std::size_t middle = (low + high) / 2, at = 2 + (2 + values.bytes) * middle;
        const std::uint16_t glyph = set.u16(at);
        if (glyph == right)
            return values.advance(set, at + 2);
        if (glyph > right)
            high = middle;
        else
            low = middle + 1;
    }
    return {};
}

/// Format 2: a matrix of classes of left and of right glyphs.
int kerningOfClasses(const FontTable& subtable, std::uint16_t left, std::uint16_t right) {
    const std::size_t leftClass = classOf(subtable.from(subtable.u16(8)), left);
    const std::size_t rightClass = classOf(subtable.from(subtable.u16(10)), right);
    const std::size_t rightClasses = subtable.u16(14);
    if (leftClass >= subtable.u16(12) || rightClass >= rightClasses)
        return 0;
    const PairValues values(subtable);
    return values.advance(subtable, 16 + values.bytes * (leftClass * rightClasses + rightClass));
}

std::optional<int> kerningBy(const FontTable& subtable, std::uint16_t left, std::uint16_t right) {
    const std::optional<std::size_t> index = coverageIndex(subtable.from(subtable.u16(2)), left);
    if (!index)
        return {};
    if (subtable.u16(0) == 1)
        return kerningOfPair(subtable, *index, right);
    return subtable.u16(0) == 2 ? std::optional(kerningOfClasses(subtable, left, right)) : std::nullopt;
}

/// The lookups of the features `kern`, by number.
std::set<std::uint16_t> lookupsOfKerning(const FontTable& features) {
    constexpr std::uint32_t kKern = 0x6B65726E;
    std::set<std::uint16_t> lookups;
    for (std::size_t i = 0; i < std::min<std::size_t>(features.u16(0), kMaxFeatures); ++i) {
        if (features.u32(2 + 6 * i) != kKern)
            continue;
        const FontTable feature = features.from(features.u16(6 + 6 * i));
        for (std::size_t k = 0; k < std::min<std::size_t>(feature.u16(2), kMaxLookupsOfFeature); ++k)
            lookups.insert(feature.u16(4 + 2 * k));
    }
    return lookups;
}

} // namespace

void Kerning::readLookup(const FontTable& lookup) {
    constexpr std::uint16_t kPairs = 2, kElsewhere = 9;
    std::vector<FontTable> subtables;
    for (std::size_t i = 0; i < std::min<std::size_t>(lookup.u16(4), kMaxSubtables); ++i) {
        FontTable subtable = lookup.from(lookup.u16(6 + 2 * i));
        std::uint16_t type = lookup.u16(0);
        if (type == kElsewhere) {
            type = subtable.u16(2);
            subtable = subtable.from(subtable.u32(4));
        }
        if (type == kPairs && subtable.size() != 0)
            subtables.push_back(subtable);
    }
    if (!subtables.empty())
        m_lookups.push_back(std::move(subtables));
}

void Kerning::readLookups(const FontTable& positioning) {
    const FontTable lookups = positioning.from(positioning.u16(8));
    for (const std::uint16_t lookup : lookupsOfKerning(positioning.from(positioning.u16(6))))
        if (lookup < lookups.u16(0) && m_lookups.size() < kMaxLookups)
            readLookup(lookups.from(lookups.u16(2 + 2 * std::size_t{lookup})));
}

void Kerning::readPairs(const FontTable& kern) {
    constexpr std::uint16_t kHorizontal = 1, kMinimum = 2, kAcross = 4;
    std::size_t at = 4;
    const std::size_t tables = kern.u16(0) == 0 ? std::min<std::size_t>(kern.u16(2), kMaxPairTables) : 0;
    for (std::size_t i = 0; i < tables; ++i) {
        const std::uint16_t coverage = kern.u16(at + 4);
        const bool isOfPairs =
            coverage >> 8U == 0 && (coverage & (kHorizontal | kMinimum | kAcross)) == kHorizontal;
        const std::size_t pairs = kern.u16(at + 6), first = at + 14;
        for (std::size_t pair = 0; isOfPairs && pair < pairs && kern.has(first + 6 * pair, 6); ++pair)
            m_pairs.push_back({kern.u32(first + 6 * pair), kern.s16(first + 6 * pair + 4)});
        at += std::max<std::size_t>(kern.u16(at + 2), 6);
    }
    std::stable_sort(m_pairs.begin(), m_pairs.end(),
                     [](const Pair& a, const Pair& b) { return a.glyphs < b.glyphs; });
}

Kerning::Kerning(const FontTable& kern, const FontTable& positioning) {
    readLookups(positioning);
    if (m_lookups.empty())
        readPairs(kern);
}

int Kerning::between(std::uint16_t left, std::uint16_t right) const {
    int units = 0;
    for (const std::vector<FontTable>& subtables : m_lookups)
        for (const FontTable& subtable : subtables)
            if (const std::optional<int> found = kerningBy(subtable, left, right)) {
                units += *found;
                break;
            }
    const std::uint32_t glyphs = static_cast<std::uint32_t>(left) << 16U | right;
    const auto pair =
        std::lower_bound(m_pairs.begin(), m_pairs.end(), glyphs,
                         [](const Pair& entry, std::uint32_t wanted) { return entry.glyphs < wanted; });
    return pair != m_pairs.end() && pair->glyphs == glyphs ? pair->units : units;
}

} // namespace franken
