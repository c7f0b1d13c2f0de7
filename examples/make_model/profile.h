// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <glm/glm.hpp>

namespace make_model {

/// A cubic Bézier curve in the plane, in metres, over t in [0, 1].
struct Bezier {
    std::array<glm::dvec2, 4> points;

    glm::dvec2 at(double t) const;
    glm::dvec2 slope(double t) const; ///< First derivative by t.
    glm::dvec2 bend(double t) const;  ///< Second derivative by t.
    double length() const;            ///< Along the curve, as the sum of 64 chords.
};

/// Grooves that run down a turned surface: the radius is multiplied by 1 + depth·fade(t)·cos(count·angle),
/// with fade = (4t(1-t))², so that a fluted piece meets its neighbours in a plain circle.
struct Flutes {
    int count = 0;      ///< Around the whole turn.
    double depth = 0.0; ///< Fraction of the radius, at the middle of the piece.
};

/// One part of a profile between two creases (or two paintings): x is the radius, y the height.
struct Piece {
    Bezier curve;
    int rings = 8; ///< Rows of quads along the curve.
    Flutes flutes{};
};

/// The outline that the lathe turns, from the top down. Texture coordinate v runs over it from 0 to 1 and is
/// shared out by length, so that a texel is about as high in one piece as in the next; within a piece it
/// is linear in t. Painting and geometry both go through this mapping and so cannot drift apart.
class Profile {
public:
    explicit Profile(std::vector<Piece> pieces);

    const std::vector<Piece>& pieces() const { return m_pieces; }
    double length(std::size_t piece) const { return m_lengths[piece]; }
    double v(std::size_t piece, double t) const;

    struct Place {
        std::size_t piece;
        double t;
    };
    /// The inverse of v().
    Place find(double v) const;

private:
    std::vector<Piece> m_pieces;
    std::vector<double> m_lengths;
    std::vector<double> m_starts; ///< v of the upper end of each piece, and 1 at the end.
};

} // namespace make_model
