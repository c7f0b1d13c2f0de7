// SPDX-License-Identifier: MIT
#include "franken/reflection.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "helper_threads.h"
#include "sky/sky.h"
#include "sky/tree.h"

namespace franken {
namespace {

constexpr float kRatio = 0.70710678f; ///< Of a level's size to that of the one before.
constexpr float kHeight = (1 - 0.0625f * kRatio) / (1 - kRatio); ///< Of all levels, in sizes of the first.

constexpr int kIrradiance = kReflectionLevels; ///< After the levels of the lobes.
constexpr float kIrradianceRow = 0.75f;        ///< Where its middle is, of the atlas's height.

struct AtlasPoint {
    int level = 0;
    glm::vec3 direction{0};
};

/// The direction d, in the upper half of the sphere or a little below, that lies at p = (d.x, d.z) (1 - d.y /
/// 2). |p| falls from 1.1 where d.y is -0.366, to which points beyond belong, to 0 where it is 1.
glm::vec3 irradianceDirection(const glm::vec2& p) {
    const float radius = glm::length(p);
    float below = -0.366f, above = 1;
    for (int halving = 0; halving < 24; ++halving) {
        const float y = 0.5f * (below + above);
        (std::sqrt(1 - y * y) * (1 - 0.5f * y) > radius ? below : above) = y;
    }
    const float scale = 1 - 0.5f * below;
    return glm::normalize(glm::vec3(p.x / scale, below, p.y / scale));
}

/// The irradiance: two rectangles right of the smaller levels, an eighth of the atlas wide and high.
std::optional<AtlasPoint> irradiancePoint(float u, float v) {
    if (u < 0.75f || std::abs(v - kIrradianceRow) > 0.0625f)
        return std::nullopt;
    const bool upper = u < 0.875f;
    const glm::vec2 p(16 * (u - (upper ? 0.8125f : 0.9375f)), 16 * (v - kIrradianceRow));
    glm::vec3 direction = irradianceDirection(p / kAtlasInner);
    direction.y = upper ? direction.y : -direction.y;
    return AtlasPoint{kIrradiance, direction};
}

/// What a point of the atlas holds; nothing beside the squares. u, v: 0 to 1.
std::optional<AtlasPoint> atlasPoint(float u, float v) {
    if (const auto irradiance = irradiancePoint(u, v))
        return irradiance;
    AtlasPoint point;
    float size = 1, top = 0;
    while (point.level + 1 < kReflectionLevels && v * kHeight >= top + size) {
        top += size;
        size *= kRatio;
        ++point.level;
    }
    if (u >= size)
        return std::nullopt;
    const bool upper = u < 0.5f * size;
    const float s = 4 * u / size - (upper ? 1 : 3), t = 2 * (v * kHeight - top) / size - 1;
    const glm::vec2 p = glm::vec2(s, t) / kAtlasInner;
    const float y = 1 - std::max(std::abs(p.x), std::abs(p.y));
    point.direction = glm::normalize(glm::vec3(p.x, upper ? y : -y, p.y));
    return point;
}

} // namespace

int reflectionHeight(int size) { return static_cast<int>(std::ceil(kHeight * static_cast<float>(size))); }

ReflectionAtlas filterReflection(const Environment& sky, int size, const Progress& progress) {
    assert(size >= kMinReflectionSize && size <= kMaxReflectionSize);
    const SkyTree tree(sky);
    std::vector<Lobe> lobes;
    for (int i = 0; i < kReflectionLevels; ++i)
        lobes.push_back(Lobe::ofRoughness(std::exp2(0.5f * static_cast<float>(i + 1 - kReflectionLevels))));
    lobes.push_back(Lobe::ofLambert());

    const int width = 2 * size, height = reflectionHeight(size);
    std::vector<glm::vec3> texels(std::size_t{1} * width * height);
    forEachRow(
        height,
        [&](int y) {
            for (int x = 0; x < width; ++x) {
                const auto point = atlasPoint((static_cast<float>(x) + 0.5f) / static_cast<float>(width),
                                              (static_cast<float>(y) + 0.5f) / static_cast<float>(height));
                if (point)
                    texels[static_cast<std::size_t>(y) * width + x] =
                        tree.radiance(lobes[static_cast<std::size_t>(point->level)], point->direction);
            }
        },
        progress);
    ReflectionAtlas atlas;
    atlas.range = rangeOf(texels, tree.meanRadiance());
    atlas.image = encodeRgbm(texels, width, height, atlas.range);
    return atlas;
}

} // namespace franken
