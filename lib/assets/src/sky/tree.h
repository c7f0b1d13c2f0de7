// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "franken/environment.h"

namespace franken {

/// How much of the light from around a direction counts, by the angle to it. The weights of a white sky
/// make 1.
class Lobe {
public:
    /// The specular lobe of glTF's BRDF where N = V. roughness: above 0 to 1.
    static Lobe ofRoughness(float roughness);

    /// What a white Lambert surface shows: the irradiance over pi.
    static Lobe ofLambert();

    /// 1/sr. cosine: of the angle, -1 to 1.
    float weight(float cosine) const;

    /// The square of the angle over which the weight changes by as much as it is.
    float squaredWidth(float cosine) const;

    /// Light of that mean cosine, which is spread with a variance of s square radians, has a mean weight of
    /// weight(cosine) (1 + s correction(cosine)), but for terms in s^2.
    float correction(float cosine) const;

    /// The derivative of the weight by the cosine where that is 0: there the weight has a bend.
    float slopeAtHorizon() const { return m_slopeAtHorizon; }

private:
    Lobe(float alpha, bool lambert);

    /// The denominator of GGX, whose square divides the weight.
    float spread(float cosine) const;

    float m_alpha2;
    bool m_lambert;
    float m_scale = 1;
    float m_slopeAtHorizon = 0;
};

/// The sum over all texels of a sky, each with its solid angle and the weight of a lobe, in the time of some
/// hundred texels: Barnes and Hut, "A hierarchical O(N log N) force-calculation algorithm", Nature 324, 1986,
/// on a sphere. Neighbours are put together, four and four, in a tree over the faces of a cube. Each node
/// knows their light and its centre, so that they count as one wherever the lobe hardly changes between them,
/// and so little depends on how the sky's light is spread: a lamp of one texel is summed as exactly as a
/// clear sky.
class SkyTree {
public:
    explicit SkyTree(const Environment& sky);

    /// Radiance through a lobe around a unit direction. tolerance: the largest error that one node may add,
    /// as a share of the result.
    glm::vec3 radiance(const Lobe& lobe, const glm::vec3& direction, float tolerance = kTolerance) const;

    /// A thirty-second of it, which takes four times the nodes, moves no texel by half a code of 8 bits.
    static constexpr float kTolerance = 3e-4f;

    /// Of the sky: the mean over all directions.
    const glm::vec3& meanRadiance() const { return m_mean; }

private:
    struct Node {
        glm::vec3 flux{0};   ///< Radiance times solid angle.
        glm::vec3 center{0}; ///< The mean direction, weighted by the sum of the channels; not unit.
        float variance = 0;  ///< Square radians around the centre.
        float tint = 0;      ///< Radians between the centres of the channels.
    };

    /// Where the nodes of a level begin. Level 0 are the cube's faces; the children of a level's node i are
    /// the next level's 4 i to 4 i + 3.
    static std::size_t levelStart(int level);

    void addTexels(const Environment& sky);
    void joinChildren(int level);

    /// When a node stands for its texels: sizes are squares, as shares of the lobe's squared width there.
    struct Detail {
        float size;  ///< Of the node: no dim light within it, beside a lamp that draws its centre, is much
                     ///< nearer.
        float share; ///< Of how far its light spreads.
        float error; ///< Of the result, summed over the channels.
    };

    glm::vec3 sum(const Lobe& lobe, const glm::vec3& direction, const Detail& detail) const;

    /// The error, summed over the channels, of a node that stands for its texels.
    static float errorOf(const Lobe& lobe, const Node& node, float cosine);

    std::vector<Node> m_nodes;
    glm::vec3 m_mean{0};
};

} // namespace franken
