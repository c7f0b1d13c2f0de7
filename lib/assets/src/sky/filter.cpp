// SPDX-License-Identifier: MIT
#include "sky/filter.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "helper_threads.h"
#include "sky/sky.h"

namespace franken {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr int kSamples = 256;
constexpr int kMaxCube = 512;
constexpr int kMinCube = 8;
constexpr std::size_t kMaxWorkers = 16;

float squared(float x) { return x * x; }

Environment halved(const Environment& cube) {
    const std::size_t from = static_cast<std::size_t>(cube.width), size = from / 2;
    Environment half{Environment::Layout::Cube, cube.width / 2, cube.height / 2, {}};
    half.texels.reserve(6 * size * size);
    for (std::size_t y = 0; y < 6 * size; ++y)
        for (std::size_t x = 0; x < size; ++x) {
            const std::size_t first = 2 * y * from + 2 * x;
            half.texels.push_back(0.25f * (cube.texels[first] + cube.texels[first + 1] +
                                           cube.texels[first + from] + cube.texels[first + from + 1]));
        }
    return half;
}

} // namespace

std::vector<glm::vec2> evenPoints(int count) {
    std::vector<glm::vec2> points;
    for (int i = 0; i < count; ++i) {
        float radical = 0, digit = 0.5f;
        for (int rest = i; rest > 0; rest /= 2, digit *= 0.5f)
            radical += static_cast<float>(rest % 2) * digit;
        points.emplace_back((static_cast<float>(i) + 0.5f) / static_cast<float>(count), radical);
    }
    return points;
}

glm::vec3 microfacet(const glm::vec2& point, float alpha) {
    const float cosine = std::sqrt((1 - point.x) / (1 + (alpha * alpha - 1) * point.x));
    const float sine = std::sqrt(std::max(1 - cosine * cosine, 0.0f));
    return {sine * std::cos(2 * kPi * point.y), sine * std::sin(2 * kPi * point.y), cosine};
}

float smithVisibility(float nDotL, float nDotV, float alpha) {
    const float a2 = alpha * alpha;
    return 0.5f / (nDotL * std::sqrt(nDotV * nDotV * (1 - a2) + a2) +
                   nDotV * std::sqrt(nDotL * nDotL * (1 - a2) + a2));
}

SkyFilter::SkyFilter(const Environment& sky) {
    const bool cube = sky.layout == Environment::Layout::Cube;
    int size = kMinCube;
    while (size < kMaxCube && size < (cube ? sky.width : sky.width / 4))
        size *= 2;
    m_levels.push_back(resampledToCube(sky, size));
    while (m_levels.back().width > kMinCube)
        m_levels.push_back(halved(m_levels.back()));
}

// Colbert and Krivanek, "GPU-Based Importance Sampling", GPU Gems 3, 2007.
int SkyFilter::levelFor(float density, int count) const {
    const float texel = 4 * kPi / static_cast<float>(m_levels[0].texels.size());
    const float level = 0.5f * std::log2(1 / (static_cast<float>(count) * density * texel)) + 0.5f;
    return static_cast<int>(std::clamp(level, 0.0f, static_cast<float>(m_levels.size() - 1)));
}

std::vector<SkyFilter::Sample> SkyFilter::cosineLobe() const {
    std::vector<Sample> samples;
    for (const glm::vec2& point : evenPoints(kSamples)) {
        const float z = std::sqrt(1 - point.x), ring = std::sqrt(point.x), angle = 2 * kPi * point.y;
        samples.push_back({glm::vec3(ring * std::cos(angle), ring * std::sin(angle), z), 1.0f / kSamples,
                           levelFor(z / kPi, kSamples)});
    }
    return samples;
}

std::vector<SkyFilter::Sample> SkyFilter::lobe(float roughness) const {
    assert(roughness > 0 && roughness <= 1);
    const float alpha = roughness * roughness;
    std::vector<Sample> samples;
    float sum = 0;
    for (const glm::vec2& point : evenPoints(kSamples)) {
        const glm::vec3 half = microfacet(point, alpha);
        const glm::vec3 direction = 2 * half.z * half - glm::vec3(0, 0, 1);
        if (direction.z <= 0)
            continue;
        const float density = squared(alpha / (1 + (alpha * alpha - 1) * half.z * half.z)) / (4 * kPi);
        const float weight = smithVisibility(direction.z, 1, alpha) * direction.z;
        samples.push_back({direction, weight, levelFor(density, kSamples)});
        sum += weight;
    }
    for (Sample& sample : samples)
        sample.weight /= sum;
    return samples;
}

glm::vec3 SkyFilter::radiance(const std::vector<Sample>& lobe, const glm::vec3& direction) const {
    const glm::vec3 other = std::abs(direction.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 x = glm::normalize(glm::cross(other, direction));
    const glm::vec3 y = glm::cross(direction, x);
    glm::vec3 sum(0);
    for (const Sample& sample : lobe) {
        const glm::vec3& d = sample.direction;
        sum += sample.weight * radianceFrom(m_levels[static_cast<std::size_t>(sample.level)],
                                            x * d.x + y * d.y + direction * d.z);
    }
    return sum;
}

void forEachRow(int count, const std::function<void(int)>& row, const Progress& progress) {
    std::atomic<int> next = 0;
    const std::function<void()> work = [&] {
        for (int y = next++; y < count; y = next++)
            row(y);
    };
    std::vector<std::jthread> helpers = startHelpers(kMaxWorkers, work);
    for (int y = next++; y < count; y = next++) {
        row(y);
        if (progress)
            progress(static_cast<float>(y) / static_cast<float>(count));
    }
    helpers.clear();
    if (progress)
        progress(1);
}

Environment filterSky(const Environment& sky, float roughness, Environment::Layout layout, int width) {
    const SkyFilter filter(sky);
    const auto lobe = filter.lobe(roughness);
    const int height = layout == Environment::Layout::Cube ? 6 * width : width / 2;
    Environment filtered{layout, width, height, std::vector<glm::vec3>(std::size_t{1} * width * height)};
    forEachRow(height,
               [&](int y) {
                   for (int x = 0; x < width; ++x)
                       filtered.texels[static_cast<std::size_t>(y) * width + x] =
                           filter.radiance(lobe, texelDirection(filtered, static_cast<float>(x) + 0.5f,
                                                                static_cast<float>(y) + 0.5f));
               },
               {});
    return filtered;
}

} // namespace franken
