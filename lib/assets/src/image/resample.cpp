// SPDX-License-Identifier: MIT
#include "franken/resample.h"

#include "image/srgb_tables.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace franken {
namespace {

/// The pixels along one axis that a pixel of the result is made of.
struct Tap {
    int pixel;
    float weight;
};

int wrapped(int pixel, int size, Wrap wrap) {
    const auto modulo = [pixel](int period) { return (pixel % period + period) % period; };
    switch (wrap) {
    case Wrap::Repeat:
        return modulo(size);
    case Wrap::MirroredRepeat:
        return std::min(modulo(2 * size), 2 * size - 1 - modulo(2 * size));
    case Wrap::ClampToEdge:
        break;
    }
    return std::clamp(pixel, 0, size - 1);
}

std::vector<Tap> tapsOf(int out, int sizeOut, int sizeIn, Wrap wrap) {
    const double scale = static_cast<double>(sizeIn) / sizeOut;
    const double radius = std::max(scale, 1.0);
    const double center = (out + 0.5) * scale - 0.5;
    std::vector<Tap> taps;
    double sum = 0;
    for (int pixel = static_cast<int>(std::ceil(center - radius)); pixel <= center + radius; ++pixel) {
        const double weight = 1 - std::abs(pixel - center) / radius;
        taps.push_back({wrapped(pixel, sizeIn, wrap), static_cast<float>(weight)});
        sum += weight;
    }
    for (Tap& tap : taps)
        tap.weight /= static_cast<float>(sum);
    return taps;
}

/// One axis of an image.
struct Axis {
    int sizeIn, sizeOut;
    Wrap wrap;
};

/// Scales rows, `count` of them, and transposes: two calls scale both axes. `read` returns the value at an
/// index of the row-major image, four to a pixel.
template<typename Read>
std::vector<float> scaledAcross(const Read& read, const Axis& axis, int count) {
    const auto pixelAt = [](int row, int rowSize, int column) {
        return 4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(rowSize) +
                    static_cast<std::size_t>(column));
    };
    std::vector<float> out(pixelAt(axis.sizeOut, count, 0));
    for (int x = 0; x < axis.sizeOut; ++x) {
        const std::vector<Tap> taps = tapsOf(x, axis.sizeOut, axis.sizeIn, axis.wrap);
        for (int y = 0; y < count; ++y)
            for (const Tap& tap : taps)
                for (std::size_t channel = 0; channel < 4; ++channel)
                    out[pixelAt(x, count, y) + channel] +=
                        tap.weight * read(pixelAt(y, axis.sizeIn, tap.pixel) + channel);
    }
    return out;
}

std::uint8_t toCode(float value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 255.0f)));
}

void encode(const float* value, TextureContents contents, std::uint8_t* code) {
    glm::vec3 rgb(value[0], value[1], value[2]);
    if (contents == TextureContents::Normals) {
        const glm::vec3 normal = rgb / 127.5f - 1.0f;
        const float length = glm::length(normal);
        rgb = (length > 1e-3f ? normal / length : glm::vec3(0, 0, 1)) * 127.5f + 127.5f;
    }
    for (int channel = 0; channel < 3; ++channel)
        code[channel] = contents == TextureContents::Color ? SrgbTables::get().codeOf(rgb[channel])
                                                           : toCode(rgb[channel]);
    code[3] = toCode(value[3]);
}

} // namespace

Image resampled(const Image& image, int width, int height, const Texture& texture, TextureContents contents) {
    const SrgbTables& tables = SrgbTables::get();
    const auto decoded = [&](std::size_t index) {
        const std::uint8_t code = image.rgba[index];
        return contents == TextureContents::Color && index % 4 != 3 ? tables.lightOf(code) : code;
    };
    const std::vector<float> columns =
        scaledAcross(decoded, {image.width, width, texture.wrapS}, image.height);
    const std::vector<float> rows = scaledAcross([&](std::size_t index) { return columns[index]; },
                                                 {image.height, height, texture.wrapT}, width);
    Image result{image.name, width, height, std::vector<std::uint8_t>(rows.size())};
    for (std::size_t i = 0; i < rows.size(); i += 4)
        encode(&rows[i], contents, &result.rgba[i]);
    return result;
}

} // namespace franken
