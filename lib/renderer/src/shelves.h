// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

namespace franken {

/// Packs rectangles into a square: side by side on shelves, each as high as the first one on it.
class Shelves {
public:
    struct Place {
        int x = 0, y = 0;
    };

    explicit Shelves(int size) : m_size(size) {}

    /// On the shelf that is least too high, and not half too high; else on a new one.
    std::optional<Place> add(int width, int height);

private:
    struct Shelf {
        int y, height, end;
    };
    int m_size;
    std::vector<Shelf> m_shelves;
};

} // namespace franken
