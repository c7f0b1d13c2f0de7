// SPDX-License-Identifier: MIT
#include "franken/mipmap.h"

#include "image/mip_taps.h"
#include "image/srgb_tables.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace franken {
namespace {

/// Calls the function with each pixel that the taps weigh, and its weight.
template<typename Function>
void forEachPixel(const Image& image, const Taps& across, const Taps& down, Function function) {
    forEachTap(image.width, across, down,
               [&](std::size_t pixel, float weight) { function(image.rgba.data() + 4 * pixel, weight); });
}

std::uint8_t toCode(float value) { return static_cast<std::uint8_t>(std::lround(std::min(value, 255.0f))); }

using Pixel = std::array<std::uint8_t, 4>;

Pixel meanColor(const Image& image, const Taps& across, const Taps& down) {
    const SrgbTables& tables = SrgbTables::get();
    std::array<float, 4> sum{};
    forEachPixel(image, across, down, [&](const std::uint8_t* rgba, float weight) {
        for (std::size_t channel = 0; channel < 3; ++channel)
            sum[channel] += weight * tables.lightOf(rgba[channel]);
        sum[3] += weight * static_cast<float>(rgba[3]);
    });
    return {tables.codeOf(sum[0]), tables.codeOf(sum[1]), tables.codeOf(sum[2]), toCode(sum[3])};
}

Pixel meanNumbers(const Image& image, const Taps& across, const Taps& down) {
    std::array<float, 4> sum{};
    forEachPixel(image, across, down, [&](const std::uint8_t* rgba, float weight) {
        for (std::size_t channel = 0; channel < 4; ++channel)
            sum[channel] += weight * static_cast<float>(rgba[channel]);
    });
    return {toCode(sum[0]), toCode(sum[1]), toCode(sum[2]), toCode(sum[3])};
}

Image halved(const Image& image, TextureContents contents) {
    const auto mean = contents == TextureContents::Color ? meanColor : meanNumbers;
    Image half{image.name, std::max(1, image.width / 2), std::max(1, image.height / 2), {}};
    half.rgba.reserve(4 * static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
    std::vector<Taps> across;
    for (int x = 0; x < half.width; ++x)
        across.push_back(tapsAt(x, image.width));
    for (int y = 0; y < half.height; ++y) {
        const Taps down = tapsAt(y, image.height);
        for (const Taps& taps : across) {
            const Pixel pixel = mean(image, taps, down);
            half.rgba.insert(half.rgba.end(), pixel.begin(), pixel.end());
        }
    }
    return half;
}

} // namespace

std::vector<Image> mipmaps(const Image& image, TextureContents contents) {
    std::vector<Image> levels;
    for (const Image* last = &image; last->width > 1 || last->height > 1; last = &levels.back())
        levels.push_back(halved(*last, contents));
    return levels;
}

} // namespace franken
