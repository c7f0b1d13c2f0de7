// SPDX-License-Identifier: MIT
#include "franken/resample.h"

#include "image/srgb_tables.h"
#include "wrapped.h"

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

/// The rows of an image, scaled across. The last ones that were asked for are kept: those below each other
/// are asked for several times.
class ScaledRows {
public:
    ScaledRows(const Image& image, int width, Wrap wrap, TextureContents contents, std::size_t kept)
        : m_image(image), m_contents(contents), m_rows(kept) {
        for (int x = 0; x < width; ++x)
            m_taps.push_back(tapsOf(x, width, image.width, wrap));
    }

    /// Four numbers to a pixel, of colours in linear light; good until the next call.
    const std::vector<float>& at(int y) {
        Row& row = m_rows[static_cast<std::size_t>(y) % m_rows.size()];
        if (row.y != y)
            fill(row, y);
        return row.values;
    }

private:
    struct Row {
        int y = -1;
        std::vector<float> values = {};
    };

    void fill(Row& row, int y) const {
        const std::size_t bytes = 4 * static_cast<std::size_t>(m_image.width);
        const std::uint8_t* const codes = m_image.rgba.data() + static_cast<std::size_t>(y) * bytes;
        row.y = y;
        row.values.assign(4 * m_taps.size(), 0);
        for (std::size_t x = 0; x < m_taps.size(); ++x)
            for (const Tap& tap : m_taps[x])
                for (std::size_t channel = 0; channel < 4; ++channel)
                    row.values[4 * x + channel] +=
                        tap.weight *
                        decoded(codes[4 * static_cast<std::size_t>(tap.pixel) + channel], channel);
    }

    float decoded(std::uint8_t code, std::size_t channel) const {
        return m_contents == TextureContents::Color && channel != 3 ? m_tables.lightOf(code) : code;
    }

    const SrgbTables& m_tables = SrgbTables::get();
    const Image& m_image;
    TextureContents m_contents;
    std::vector<std::vector<Tap>> m_taps; ///< By pixel of a scaled row.
    std::vector<Row> m_rows;
};

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
    const std::size_t kept = tapsOf(0, height, image.height, texture.wrapT).size() + 1;
    ScaledRows rows(image, width, texture.wrapS, contents, kept);
    Image result{image.name, width, height, {}};
    result.rgba.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    std::uint8_t* code = result.rgba.data();
    for (int y = 0; y < height; ++y) {
        std::vector<float> sum(4 * static_cast<std::size_t>(width));
        for (const Tap& tap : tapsOf(y, height, image.height, texture.wrapT)) {
            const std::vector<float>& row = rows.at(tap.pixel);
            for (std::size_t i = 0; i < sum.size(); ++i)
                sum[i] += tap.weight * row[i];
        }
        for (std::size_t i = 0; i < sum.size(); i += 4, code += 4)
            encode(&sum[i], contents, code);
    }
    return result;
}

} // namespace franken
