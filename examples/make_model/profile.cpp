// SPDX-License-Identifier: MIT
#include "profile.h"

#include <utility>

namespace make_model {

glm::dvec2 Bezier::at(double t) const {
    const double s = 1.0 - t;
    return s * s * s * points[0] + 3.0 * s * s * t * points[1] + 3.0 * s * t * t * points[2] +
           t * t * t * points[3];
}

glm::dvec2 Bezier::slope(double t) const {
    const double s = 1.0 - t;
    return 3.0 * s * s * (points[1] - points[0]) + 6.0 * s * t * (points[2] - points[1]) +
           3.0 * t * t * (points[3] - points[2]);
}

glm::dvec2 Bezier::bend(double t) const {
    return 6.0 * (1.0 - t) * (points[2] - 2.0 * points[1] + points[0]) +
           6.0 * t * (points[3] - 2.0 * points[2] + points[1]);
}

double Bezier::length() const {
    constexpr int kChords = 64;
    double sum = 0.0;
    for (int i = 0; i < kChords; ++i)
        sum += glm::distance(at(i / double(kChords)), at((i + 1) / double(kChords)));
    return sum;
}

Profile::Profile(std::vector<Piece> pieces) : m_pieces(std::move(pieces)) {
    double total = 0.0;
    for (const Piece& piece : m_pieces) {
        m_lengths.push_back(piece.curve.length());
        total += m_lengths.back();
    }
    double sum = 0.0;
    for (const double length : m_lengths) {
        m_starts.push_back(sum / total);
        sum += length;
    }
    m_starts.push_back(1.0);
}

double Profile::v(std::size_t piece, double t) const {
    return glm::mix(m_starts[piece], m_starts[piece + 1], t);
}

Profile::Place Profile::find(double v) const {
    std::size_t piece = 0;
    while (piece + 1 < m_pieces.size() && v >= m_starts[piece + 1])
        ++piece;
    return {piece, (v - m_starts[piece]) / (m_starts[piece + 1] - m_starts[piece])};
}

} // namespace make_model
