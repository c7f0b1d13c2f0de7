// SPDX-License-Identifier: MIT
#include "franken/key_table.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <utility>

namespace franken {

void KeyTable::insert(const Key& key, std::uint32_t place) {
    assert(key != kNoKey && find(key) == kAbsent);
    if (2 * ++m_used > m_cells.size())
        reserve(2 * m_cells.size());
    put({key, place});
}

void KeyTable::put(const Cell& entry) {
    std::size_t cell = home(entry.key);
    while (m_cells[cell].key != kNoKey)
        cell = (cell + 1) & m_mask;
    m_cells[cell] = entry;
}

void KeyTable::clear() {
    std::fill(m_cells.begin(), m_cells.end(), Cell{});
    m_used = 0;
}

void KeyTable::reserve(std::size_t cells) {
    const std::vector<Cell> old = std::exchange(m_cells, std::vector<Cell>(cells));
    m_mask = cells - 1;
    m_shift = 64 - static_cast<unsigned>(std::countr_zero(cells));
    for (const Cell& moved : old)
        if (moved.key != kNoKey)
            put(moved);
}

} // namespace franken
