// SPDX-License-Identifier: MIT
#pragma once

#include "font/table.h"

#include <cstdint>
#include <vector>

namespace franken {

/// How much nearer two neighbouring glyphs come, or further apart: the pair adjustments of GPOS's feature
/// `kern` of all scripts, formats 1 and 2; where there is none, the table kern, format 0. What is broken of
/// either kerns nothing. (OpenType 1.9, "GPOS", "kern")
class Kerning {
public:
    Kerning() = default;
    Kerning(const FontTable& kern, const FontTable& positioning);

    /// To add to the left one's advance, in units of the em; 0 for most.
    int between(std::uint16_t left, std::uint16_t right) const;

private:
    struct Pair {
        std::uint32_t glyphs; ///< The left one in the upper 16 bits.
        std::int16_t units;
    };

    void readLookups(const FontTable& positioning);
    void readLookup(const FontTable& lookup);
    void readPairs(const FontTable& kern);

    std::vector<std::vector<FontTable>>
        m_lookups;             ///< The subtables of each; the first that knows a pair counts.
    std::vector<Pair> m_pairs; ///< By glyphs.
};

} // namespace franken
