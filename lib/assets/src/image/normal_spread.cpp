// SPDX-License-Identifier: MIT
#include "franken/normal_spread.h"

#include "image/mip_taps.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace franken {
namespace {

/// Mean normals, shorter the more they differ.
struct Means {
    int width, height;
    std::vector<glm::vec3> normals;
};

/// What the smaller level is made of: `normalAt` tells a pixel's of the larger one.
template<typename NormalAt>
Means halved(int width, int height, NormalAt normalAt) {
    Means half{std::max(1, width / 2), std::max(1, height / 2), {}};
    half.normals.reserve(static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
    for (int y = 0; y < half.height; ++y)
        for (int x = 0; x < half.width; ++x) {
            glm::vec3 sum(0);
            forEachTap(width, tapsAt(x, width), tapsAt(y, height),
                       [&](std::size_t pixel, float weight) { sum += weight * normalAt(pixel); });
            half.normals.push_back(sum);
        }
    return half;
}

/// As a shader reads it: of a scale of 0, or where the map has none, the vertex's own.
glm::vec3 unitNormal(const std::uint8_t* rgba, float scale) {
    constexpr float kMiddle = 127.5f;
    const glm::vec3 normal(scale * (static_cast<float>(rgba[0]) - kMiddle),
                           scale * (static_cast<float>(rgba[1]) - kMiddle),
                           static_cast<float>(rgba[2]) - kMiddle);
    const float length = glm::length(normal);
    return length > 0 ? normal / length : glm::vec3(0, 0, 1);
}

float varianceOf(const glm::vec3& mean) {
    constexpr float kShortest = 0.05f; // Wider than any lobe.
    const float length = std::clamp(glm::length(mean), kShortest, 1.0f);
    return (1 - length) / length;
}

/// Nearest, of an axis with `of` pixels to one with `to`.
int placeOf(int at, int of, int to) {
    return static_cast<int>((static_cast<std::int64_t>(2 * at) + 1) * to / (std::int64_t{2} * of));
}

} // namespace

NormalSpread::NormalSpread(const Image& normals, float scale)
    : m_width(normals.width), m_height(normals.height) {
    if (m_width <= 1 && m_height <= 1)
        return;
    Means means = halved(m_width, m_height, [&](std::size_t pixel) {
        return unitNormal(normals.rgba.data() + 4 * pixel, scale);
    });
    while (true) {
        Level level{means.width, means.height, std::vector<float>(means.normals.size())};
        std::transform(means.normals.begin(), means.normals.end(), level.variance.begin(), varianceOf);
        m_levels.push_back(std::move(level));
        if (means.width == 1 && means.height == 1)
            return;
        means = halved(means.width, means.height, [&](std::size_t pixel) { return means.normals[pixel]; });
    }
}

void NormalSpread::roughen(Image& image, std::size_t channel, float factor) const {
    if (factor <= 0 || !widens(image))
        return;
    const auto level = std::find_if(m_levels.begin(), m_levels.end(), [&](const Level& each) {
        return each.width <= image.width && each.height <= image.height;
    });
    std::uint8_t* code = image.rgba.data() + channel;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x, code += 4) {
            const auto at = static_cast<std::size_t>(placeOf(y, image.height, level->height)) *
                                static_cast<std::size_t>(level->width) +
                            static_cast<std::size_t>(placeOf(x, image.width, level->width));
            const float roughness = factor * static_cast<float>(*code) / 255;
            const float alpha = roughness * roughness;
            const float wide = std::sqrt(std::sqrt(alpha * alpha + kWidening * level->variance[at]));
            *code = static_cast<std::uint8_t>(
                std::lround(255 * std::min(1.0f, std::max(roughness, wide) / factor)));
        }
}

} // namespace franken
