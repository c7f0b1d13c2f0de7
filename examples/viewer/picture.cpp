// SPDX-License-Identifier: MIT
#include "picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>

using namespace franken;

Image halved(const Image& image) {
    Image half;
    half.width = image.width / 2;
    half.height = image.height / 2;
    const std::size_t row = 4 * static_cast<std::size_t>(image.width);
    for (int y = 0; y < half.height; ++y)
        for (int x = 0; x < half.width; ++x)
            for (std::size_t channel = 0; channel < 4; ++channel) {
                const std::uint8_t* p = image.rgba.data() + 2 * static_cast<std::size_t>(y) * row +
                                        8 * static_cast<std::size_t>(x) + channel;
                half.rgba.push_back(static_cast<std::uint8_t>((p[0] + p[4] + p[row] + p[row + 4] + 2) / 4));
            }
    return half;
}

void paste(const Image& picture, int x, Image& into) {
    const std::ptrdiff_t from = std::ptrdiff_t{4} * picture.width, to = std::ptrdiff_t{4} * into.width;
    for (int y = 0; y < picture.height; ++y)
        std::copy_n(picture.rgba.begin() + y * from, from,
                    into.rgba.begin() + y * to + std::ptrdiff_t{4} * x);
}

Coverage coverageOf(const Image& image, const Float3& background) {
    std::array<int, 3> codes{};
    for (std::size_t channel = 0; channel < 3; ++channel)
        codes[channel] = static_cast<int>(std::lround(255 * std::clamp(background[channel], 0.0f, 1.0f)));
    Coverage coverage;
    for (std::size_t i = 0; i + 3 < image.rgba.size(); i += 4) {
        bool shown = false, white = true;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const int code = image.rgba[i + channel];
            shown = shown || std::abs(code - codes[channel]) > 1; // drivers round as they like
            white = white && code == 255;
        }
        coverage.shown += shown ? 1 : 0;
        coverage.white += shown && white ? 1 : 0;
    }
    return coverage;
}
