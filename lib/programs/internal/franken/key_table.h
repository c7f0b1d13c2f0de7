// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/permutation.h"

#include <cstdint>
#include <vector>

namespace FRANKEN_API franken {

/// Maps a key to the index of its entry: a flat table with open addressing, at most half full. It
/// compares whole keys; a hash only says where to begin.
class KeyTable {
public:
    static constexpr std::uint32_t kAbsent = ~std::uint32_t{0};

    KeyTable() { reserve(8); }

    std::uint32_t find(const Key& key) const {
        for (std::size_t cell = home(key);; cell = (cell + 1) & m_mask) {
            if (m_cells[cell].key == key)
                return m_cells[cell].place;
            if (m_cells[cell].key == kNoKey)
                return kAbsent;
        }
    }

    /// The key must not be there yet.
    void insert(const Key& key, std::uint32_t place);
    void clear();

private:
    static constexpr Key kNoKey{}; ///< No key is all zeros: each has a schema version.
    struct Cell {
        Key key = kNoKey;
        std::uint32_t place = kAbsent;
    };

    void reserve(std::size_t cells);
    void put(const Cell& entry);

    std::size_t home(const Key& key) const { return static_cast<std::size_t>(hashOf(key) >> m_shift); }

    std::vector<Cell> m_cells;
    std::size_t m_used = 0;
    std::size_t m_mask = 0;
    unsigned m_shift = 0;
};

} // namespace franken
