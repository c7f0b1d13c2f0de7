// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include <glm/glm.hpp>

#include "image.h"
#include "profile.h"

namespace make_model {

/// What a painter says about one point of a surface.
struct Surface {
    glm::dvec3 colour{0.5}; ///< Base colour, encoded (sRGB), 0 to 1: painters mix what they see.
    double metallic = 0.0;  ///< 0 or 1, and between only where a texel shows both.
    double roughness = 0.5; ///< Perceptual, 0 to 1.
    double height = 0.0;    ///< Relief above the turned surface, metres.
    double openness = 1.0;  ///< Occlusion by the shape as a whole: 1 = sees the whole sky.
    glm::dvec3 glow{0.0};   ///< Emitted light, encoded (sRGB), 0 to 1.
};

/// `under` where amount is 0, `over` where it is 1; heights, too.
Surface blend(const Surface& under, const Surface& over, double amount);

/// Where a painter is asked. Lengths are those on the surface itself, so that a circle in metres is a
/// circle on the urn.
struct Spot {
    std::size_t piece; ///< Which piece of the profile.
    double u;          ///< 0 to 1 from left to right over one sector.
    double t;          ///< 0 to 1 from the upper to the lower end of the piece.
    double v;          ///< 0 to 1 over the whole profile.
    double width;      ///< Of one sector around the axis at this height, metres.
    double length;     ///< Of the piece along the profile, metres.
    double texel;      ///< The longer side of the texel, metres: how sharp an outline can be.

    double x() const { return u * width; }          ///< Metres to the right of the sector's left edge.
    double y() const { return (0.5 - t) * length; } ///< Metres above the middle of the piece.
};

using Painter = std::function<Surface(const Spot&)>;

/// A square texture of a turned surface before it is split into images: it wraps around in x.
class Canvas {
public:
    /// Asks the painter once for the centre of each texel. `sectors` as in Turning.
    Canvas(const Profile& profile, int sectors, int size, const Painter& painter);

    Image baseColour() const;
    /// Tangent space, X right, Y up, from central differences of the heights in metres, so that the relief
    /// has its true steepness wherever the texture is stretched.
    Image normals() const;
    /// R occlusion, G roughness, B metallic.
    Image occlusionRoughnessMetallic() const;
    /// R alone.
    Image occlusion() const;
    Image emissive() const;

private:
    const Surface& at(int column, int row) const;
    void findCrevices();

    int m_size;
    std::vector<Surface> m_texels;
    std::vector<double> m_texelWidths;  ///< Per row, metres.
    std::vector<double> m_texelHeights; ///< Per row, metres.
    std::vector<double> m_occlusion;    ///< Openness, and crevices of the relief, per texel.
};

} // namespace make_model
