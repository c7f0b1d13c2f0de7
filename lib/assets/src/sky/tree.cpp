// SPDX-License-Identifier: MIT
#include "sky/tree.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

#include "sky/sky.h"

namespace franken {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr int kLeafLevel = 9; ///< Faces of 512 x 512: half of the sharpest lobe's width.
constexpr int kLeafSize = 1 << kLeafLevel;

float squared(float x) { return x * x; }

/// The sum over the channels.
float total(const glm::vec3& light) { return light.r + light.g + light.b; }

/// Bits of x at even places, of y at odd ones: four neighbours follow each other.
std::size_t interleaved(unsigned x, unsigned y) {
    std::size_t bits = 0;
    for (unsigned bit = 0; bit < kLeafLevel; ++bit)
        bits |= std::size_t{x >> bit & 1} << (2 * bit) | std::size_t{y >> bit & 1} << (2 * bit + 1);
    return bits;
}

/// The leaf that a direction belongs to.
std::size_t leafOf(const glm::vec3& direction) {
    static const std::array<std::size_t, kLeafSize> spaced = [] {
        std::array<std::size_t, kLeafSize> bits{};
        for (unsigned x = 0; x < kLeafSize; ++x)
            bits[x] = interleaved(x, 0);
        return bits;
    }();
    const FacePoint point = facePoint(direction);
    const glm::ivec2 texel = glm::clamp(glm::ivec2((point.st + 1.0f) * (0.5f * kLeafSize)), 0, kLeafSize - 1);
    return (static_cast<std::size_t>(point.face) << (2 * kLeafLevel)) +
           spaced[static_cast<std::size_t>(texel.x)] + 2 * spaced[static_cast<std::size_t>(texel.y)];
}

/// The parts along an edge that a texel is cut into, so that none is much larger than a leaf.
int partsPerTexel(const Environment& sky) {
    const bool cube = sky.layout == Environment::Layout::Cube;
    const float texel = (cube ? 2.0f : 2 * kPi) / static_cast<float>(sky.width);
    return std::max(1, static_cast<int>(std::ceil(texel * 0.75f * kLeafSize)));
}

} // namespace

Lobe::Lobe(float alpha, bool lambert) : m_alpha2(alpha * alpha), m_lambert(lambert) {
    // The weights' integral, by 1 - cosine on a logarithmic scale: the sharpest lobe needs the first 1e-9.
    constexpr int kSteps = 4096;
    const double first = std::log(1e-9), step = -first / kSteps;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double part = std::exp(first + (i + 0.5) * step);
        sum += static_cast<double>(weight(static_cast<float>(1 - part))) * part * step;
    }
    m_scale = static_cast<float>(1 / (2 * std::numbers::pi * sum));
    constexpr float kNear = 0.25f;
    m_slopeAtHorizon = weight(kNear) / kNear;
}

Lobe Lobe::ofRoughness(float roughness) {
    assert(roughness > 0 && roughness <= 1);
    return {roughness * roughness, false};
}

Lobe Lobe::ofLambert() { return {1, true}; }

float Lobe::spread(float cosine) const { return m_alpha2 + (1 - m_alpha2) * 0.5f * (1 - cosine); }

// glTF 2.0, appendix B, with N.H^2 = (1 + N.L) / 2.
float Lobe::weight(float cosine) const {
    if (cosine <= 0)
        return 0;
    if (m_lambert)
        return m_scale * cosine;
    const float width = spread(cosine);
    const float shadowing = cosine + std::sqrt(cosine * cosine * (1 - m_alpha2) + m_alpha2);
    return m_scale * m_alpha2 * cosine / (width * width * shadowing);
}

float Lobe::squaredWidth(float cosine) const { return m_lambert ? 1 : std::min(4 * spread(cosine), 1.0f); }

// The variance of the cosine is s sine^2 / 2, and the weight's second derivative 1.5 slope^2 of it.
float Lobe::correction(float cosine) const {
    const float slope = m_lambert ? 0 : (1 - m_alpha2) / spread(cosine);
    return 0.375f * (1 - cosine * cosine) * slope * slope;
}

std::size_t SkyTree::levelStart(int level) { return 2 * ((std::size_t{1} << (2 * level)) - 1); }

SkyTree::SkyTree(const Environment& sky) : m_nodes(levelStart(kLeafLevel + 1)) {
    addTexels(sky);
    for (int level = kLeafLevel - 1; level >= 0; --level)
        joinChildren(level);
    for (std::size_t face = 0; face < 6; ++face)
        m_mean += m_nodes[face].flux / (4 * kPi);
}

void SkyTree::addTexels(const Environment& sky) {
    Node* const leaves = &m_nodes[levelStart(kLeafLevel)];
    forEachPart(sky, partsPerTexel(sky),
                [&](const glm::vec2& point, const glm::vec3& direction, double solidAngle) {
                    const glm::vec3 flux = radianceAt(sky, point) * static_cast<float>(solidAngle);
                    Node& leaf = leaves[leafOf(direction)];
                    leaf.flux += flux;
                    leaf.center += total(flux) * direction;
                });
    for (std::size_t i = levelStart(kLeafLevel); i < m_nodes.size(); ++i)
        if (Node& leaf = m_nodes[i]; total(leaf.flux) > 0) {
            leaf.center /= total(leaf.flux);
            leaf.variance = std::max(1 - glm::dot(leaf.center, leaf.center), 0.0f);
        }
}

void SkyTree::joinChildren(int level) {
    for (std::size_t i = levelStart(level); i < levelStart(level + 1); ++i) {
        const Node* const children = &m_nodes[levelStart(level + 1) + 4 * (i - levelStart(level))];
        Node& node = m_nodes[i];
        for (int c = 0; c < 4; ++c) {
            node.flux += children[c].flux;
            node.center += total(children[c].flux) * children[c].center;
        }
        const float light = total(node.flux);
        if (light <= 0)
            continue;
        node.center /= light;
        std::array<glm::vec3, 3> apart{};
        for (int c = 0; c < 4; ++c) {
            const glm::vec3 offset = children[c].center - node.center;
            node.variance +=
                total(children[c].flux) / light * (children[c].variance + glm::dot(offset, offset));
            node.tint = std::max(node.tint, children[c].tint);
            for (int channel = 0; channel < 3; ++channel)
                apart[channel] += 3 * children[c].flux[channel] / light * offset;
        }
        node.tint += std::max({glm::length(apart[0]), glm::length(apart[1]), glm::length(apart[2])});
    }
}

glm::vec3 SkyTree::radiance(const Lobe& lobe, const glm::vec3& direction, float tolerance) const {
    constexpr float kDark = 0.02f; ///< Of the sky's mean: what is darker may err as much.
    const Detail rough{.size = 1, .share = 0.3f, .error = std::numeric_limits<float>::infinity()};
    const float estimate = std::max(total(sum(lobe, direction, rough)), kDark * total(m_mean));
    return sum(lobe, direction, {.size = 0.25f, .share = 0.1f, .error = tolerance * estimate});
}

glm::vec3 SkyTree::sum(const Lobe& lobe, const glm::vec3& direction, const Detail& detail) const {
    struct Place {
        int level;
        std::size_t index; ///< Within the level.
    };
    std::array<Place, 6 + 3 * kLeafLevel> open;
    std::size_t count = 0;
    for (std::size_t face = 0; face < 6; ++face)
        open[count++] = {0, face};
    glm::vec3 light(0);
    while (count > 0) {
        const auto [level, index] = open[--count];
        const Node& node = m_nodes[levelStart(level) + index];
        const float radius = 1.5f / static_cast<float>(1 << level); // half a diagonal, or a little more
        const float cosine = glm::dot(direction, node.center);
        if (cosine <= -radius || total(node.flux) <= 0)
            continue;
        const float width = lobe.squaredWidth(cosine);
        const bool near = squared(radius) > detail.size * width || node.variance > detail.share * width ||
                          squared(node.tint) > squared(detail.share) * width;
        if (level < kLeafLevel && (near || errorOf(lobe, node, cosine) > detail.error)) {
            for (std::size_t child = 0; child < 4; ++child)
                open[count++] = {level + 1, 4 * index + child};
            continue;
        }
        light += node.flux * (lobe.weight(cosine) * (1 + node.variance * lobe.correction(cosine)));
    }
    return light;
}

float SkyTree::errorOf(const Lobe& lobe, const Node& node, float cosine) {
    const float width = lobe.squaredWidth(cosine);
    const float share = 2 * node.variance / width + 4 * node.tint / std::sqrt(width);
    // Where part of a node is below the horizon, the mean of the weights is not that of their cosines.
    const float deviation = std::sqrt(node.variance);
    const float bend = std::abs(cosine) < 2 * deviation ? 0.3f * deviation * lobe.slopeAtHorizon() : 0;
    return total(node.flux) * (lobe.weight(cosine) * share + bend);
}

} // namespace franken
