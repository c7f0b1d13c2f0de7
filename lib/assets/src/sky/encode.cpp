// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>

#include <glm/exponential.hpp>

#include "sky/sky.h"

namespace franken {
namespace {

/// The real spherical harmonics of a unit direction, in the order of SkyCoefficients (Ramamoorthi and
/// Hanrahan, 2001, equation 3).
std::array<double, 9> harmonics(const glm::dvec3& d) {
    return {0.282095,
            0.488603 * d.y,
            0.488603 * d.z,
            0.488603 * d.x,
            1.092548 * d.x * d.y,
            1.092548 * d.y * d.z,
            0.315392 * (3.0 * d.z * d.z - 1.0),
            1.092548 * d.x * d.z,
            0.546274 * (d.x * d.x - d.y * d.y)};
}

/// How many samples a side each texel of a cube takes, so that none of the sky's texels is left out.
int samplesPerTexel(const Environment& sky, int size) {
    const bool cube = sky.layout == Environment::Layout::Cube;
    const double skyTexel = cube ? 2.0 / sky.width : 2.0 * std::numbers::pi / sky.width;
    return std::max(1, static_cast<int>(std::ceil(2.0 / size / skyTexel)));
}

glm::vec3 meanRadiance(const Environment& sky, int face, const glm::ivec2& texel, int size, int samples) {
    const float scale = 2.0f / static_cast<float>(size * samples);
    glm::vec3 sum(0);
    for (int i = 0; i < samples * samples; ++i) {
        const glm::vec2 point(texel.x * samples + i % samples, texel.y * samples + i / samples);
        sum += radianceFrom(sky, faceDirection(face, (point + 0.5f) * scale - 1.0f));
    }
    return sum / static_cast<float>(samples * samples);
}

std::uint8_t toCode(float value) { return static_cast<std::uint8_t>(std::clamp(value, 0.0f, 255.0f)); }

/// From one code of alpha to the next, what is filtered between two texels may err by a quarter of the square
/// of 1 / alpha: from here on nobody sees that. Darker texels share this alpha and go by RGB alone.
constexpr float kLeastAlpha = 16;

/// Alpha is rounded up, so that RGB fits below it. What exceeds the range is white.
void appendRgbm(std::vector<std::uint8_t>& rgba, const glm::vec3& radiance, float range) {
    const float most = std::max({radiance.r, radiance.g, radiance.b, range});
    const glm::vec3 root = glm::sqrt(radiance / most);
    const float alpha = std::max(std::ceil(255.0f * std::max({root.r, root.g, root.b})), kLeastAlpha);
    const glm::vec3 rgb = root * (255.0f * 255.0f / alpha) + 0.5f;
    rgba.insert(rgba.end(), {toCode(rgb.r), toCode(rgb.g), toCode(rgb.b), toCode(alpha)});
}

} // namespace

SkyCoefficients skyCoefficients(const Environment& sky) {
    std::array<glm::dvec3, 9> sums{};
    forEachPart(sky, 1, [&](const glm::vec2& point, const glm::vec3& direction, double solidAngle) {
        const glm::dvec3 light = glm::dvec3(radianceAt(sky, point)) * solidAngle;
        const std::array<double, 9> basis = harmonics(direction);
        for (std::size_t i = 0; i < sums.size(); ++i)
            sums[i] += light * basis[i];
    });
    SkyCoefficients coefficients{};
    for (std::size_t i = 0; i < sums.size(); ++i)
        coefficients[i] = {static_cast<float>(sums[i].r), static_cast<float>(sums[i].g),
                           static_cast<float>(sums[i].b)};
    return coefficients;
}

Environment resampledToCube(const Environment& sky, int size) {
    const int samples = samplesPerTexel(sky, size);
    Environment cube{Environment::Layout::Cube, size, 6 * size, {}};
    cube.texels.reserve(std::size_t{6} * size * size);
    for (int y = 0; y < cube.height; ++y)
        for (int x = 0; x < size; ++x)
            cube.texels.push_back(meanRadiance(sky, y / size, {x, y % size}, size, samples));
    return cube;
}

float rangeOf(std::span<const glm::vec3> texels, const glm::vec3& mean) {
    float range = 0;
    for (const glm::vec3& texel : texels)
        range = std::max({range, texel.r, texel.g, texel.b});
    const float most = kMaxSkyContrast * std::max({mean.r, mean.g, mean.b});
    return std::max(std::min(range, most), kMinSkyRange);
}

Image encodeRgbm(std::span<const glm::vec3> texels, int width, int height, float range) {
    Image image{"", width, height, {}};
    image.rgba.reserve(4 * texels.size());
    for (const glm::vec3& texel : texels)
        appendRgbm(image.rgba, texel, range);
    return image;
}

SkyboxMap encodeSkybox(const Environment& sky, int size) {
    assert(size >= 1 && size <= kMaxSkyWidth / 4);
    const Environment linear = resampledToCube(sky, size);
    const glm::vec3 mean = std::accumulate(linear.texels.begin(), linear.texels.end(), glm::vec3(0)) /
                           static_cast<float>(linear.texels.size());
    SkyboxMap cube{size, rangeOf(linear.texels, mean), {}};
    const std::size_t face = linear.texels.size() / 6;
    for (std::size_t i = 0; i < 6; ++i)
        cube.images[i] = encodeRgbm(std::span(linear.texels).subspan(i * face, face), size, size, cube.range);
    return cube;
}

} // namespace franken
