// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

namespace franken {

/// The pixels along an axis that one pixel of half the size covers: of an odd size, three in part, because
/// the pixels of the smaller picture are a little wider than two.
struct Taps {
    std::array<int, 3> pixel;
    std::array<float, 3> weight;
};

inline Taps tapsAt(int x, int size) {
    const int first = 2 * x, half = size / 2;
    if (size == 1)
        return {{0, 0, 0}, {1, 0, 0}};
    if (size % 2 == 0)
        return {{first, first + 1, first + 1}, {0.5f, 0.5f, 0}};
    const auto whole = static_cast<float>(size);
    return {{first, first + 1, first + 2},
            {static_cast<float>(half - x) / whole, static_cast<float>(half) / whole,
             static_cast<float>(x + 1) / whole}};
}

/// Calls the function with the place of each pixel that the taps weigh, in a picture of that width, and its
/// weight.
template<typename Function>
void forEachTap(int width, const Taps& across, const Taps& down, Function function) {
    for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t i = 0; i < 3; ++i) {
            const float weight = across.weight[i] * down.weight[j];
            const auto pixel = static_cast<std::size_t>(down.pixel[j]) * static_cast<std::size_t>(width) +
                               static_cast<std::size_t>(across.pixel[i]);
            if (weight > 0)
                function(pixel, weight);
        }
}

} // namespace franken
