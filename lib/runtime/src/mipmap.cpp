// SPDX-License-Identifier: MIT
#include "mipmap.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace franken {
namespace {

constexpr std::size_t kSteps = 16'384; // Of light; a quarter of a code apart where the curve is steepest.

/// The sRGB curve (IEC 61966-2-1) both ways.
struct Tables {
    std::array<float, 256> light;
    std::array<std::uint8_t, kSteps + 1> code;

    Tables() {
        for (std::size_t i = 0; i < light.size(); ++i) {
            const double c = static_cast<double>(i) / 255;
            light[i] = static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
        }
        for (std::size_t i = 0; i < code.size(); ++i) {
            const double l = static_cast<double>(i) / kSteps;
            const double c = l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1 / 2.4) - 0.055;
            code[i] = static_cast<std::uint8_t>(std::lround(255 * c));
        }
    }
};

using Four = std::array<std::uint8_t, 4>;

std::uint8_t meanColor(const Four& codes) {
    static const Tables tables;
    float light = 0;
    for (const std::uint8_t code : codes)
        light += tables.light[code];
    return tables.code[static_cast<std::size_t>(std::lround(light * 0.25f * kSteps))];
}

std::uint8_t meanAlpha(const Four& a) {
    return static_cast<std::uint8_t>((a[0] + a[1] + a[2] + a[3] + 2) / 4);
}

Image halved(const Image& image) {
    Image half{image.name, std::max(1, image.width / 2), std::max(1, image.height / 2), {}};
    half.rgba.reserve(4 * static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
    const auto at = [&](int x, int y, int channel) {
        const auto pixel =
            static_cast<std::size_t>(std::min(y, image.height - 1)) * static_cast<std::size_t>(image.width) +
            static_cast<std::size_t>(std::min(x, image.width - 1));
        return image.rgba[4 * pixel + static_cast<std::size_t>(channel)];
    };
    for (int y = 0; y < half.height; ++y)
        for (int x = 0; x < half.width; ++x)
            for (int channel = 0; channel < 4; ++channel) {
                const Four four = {at(2 * x, 2 * y, channel), at(2 * x + 1, 2 * y, channel),
                                   at(2 * x, 2 * y + 1, channel), at(2 * x + 1, 2 * y + 1, channel)};
                half.rgba.push_back(channel < 3 ? meanColor(four) : meanAlpha(four));
            }
    return half;
}

} // namespace

std::vector<Image> srgbMipmaps(const Image& image) {
    std::vector<Image> levels;
    for (const Image* last = &image; last->width > 1 || last->height > 1; last = &levels.back())
        levels.push_back(halved(*last));
    return levels;
}

} // namespace franken
