// SPDX-License-Identifier: MIT
#include "resample.h"

#include <algorithm>
#include <cmath>

namespace franken {
namespace {

/// The pixels along one axis that a pixel of the result is made of.
struct Tap {
    int pixel;
    float weight;
};

std::vector<Tap> tapsOf(int out, int sizeOut, int sizeIn) {
    const double scale = static_cast<double>(sizeIn) / sizeOut;
    const double radius = std::max(scale, 1.0);
    const double center = (out + 0.5) * scale - 0.5;
    std::vector<Tap> taps;
    double sum = 0;
    for (int pixel = static_cast<int>(std::ceil(center - radius)); pixel <= center + radius; ++pixel) {
        const double weight = 1 - std::abs(pixel - center) / radius;
        taps.push_back({std::clamp(pixel, 0, sizeIn - 1), static_cast<float>(weight)});
        sum += weight;
    }
    for (Tap& tap : taps)
        tap.weight /= static_cast<float>(sum);
    return taps;
}

/// Scales rows of `sizeIn` pixels, `count` of them, and transposes: two calls scale both axes.
std::vector<float> scaledAcross(const std::vector<float>& in, int sizeIn, int count, int sizeOut) {
    std::vector<float> out(4 * static_cast<std::size_t>(sizeOut) * static_cast<std::size_t>(count));
    const auto pixelAt = [](int row, int rowSize, int column) {
        return 4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(rowSize) +
                    static_cast<std::size_t>(column));
    };
    for (int x = 0; x < sizeOut; ++x) {
        const std::vector<Tap> taps = tapsOf(x, sizeOut, sizeIn);
        for (int y = 0; y < count; ++y)
            for (const Tap& tap : taps)
                for (std::size_t channel = 0; channel < 4; ++channel)
                    out[pixelAt(x, count, y) + channel] +=
                        tap.weight * in[pixelAt(y, sizeIn, tap.pixel) + channel];
    }
    return out;
}

} // namespace

Image resampled(const Image& image, int width, int height) {
    const std::vector<float> pixels(image.rgba.begin(), image.rgba.end());
    const std::vector<float> columns = scaledAcross(pixels, image.width, image.height, width);
    const std::vector<float> rows = scaledAcross(columns, image.height, width, height);
    Image result{image.name, width, height, {}};
    result.rgba.reserve(rows.size());
    for (const float value : rows)
        result.rgba.push_back(static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 255.0f))));
    return result;
}

} // namespace franken
