// SPDX-License-Identifier: MIT
#include "shelves.h"

namespace franken {

std::optional<Shelves::Place> Shelves::add(int width, int height) {
    Shelf* best = nullptr;
    for (Shelf& shelf : m_shelves)
        if (shelf.height >= height && shelf.height <= height + height / 2 && shelf.end + width <= m_size &&
            (best == nullptr || shelf.height < best->height))
            best = &shelf;
    if (best == nullptr) {
        const int top = m_shelves.empty() ? 0 : m_shelves.back().y + m_shelves.back().height;
        if (width > m_size || top + height > m_size)
            return {};
        best = &m_shelves.emplace_back(Shelf{top, height, 0});
    }
    best->end += width;
    return Place{best->end - width, best->y};
}

} // namespace franken
