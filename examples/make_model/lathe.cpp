// SPDX-License-Identifier: MIT
#include "lathe.h"

#include <cassert>
#include <cmath>
#include <numbers>

#include "numbers.h"

namespace make_model {
namespace {

void appendVertex(Mesh& mesh, const Piece& piece, double t, double turns) {
    const double sine = sinTurns(turns);
    const double cosine = cosTurns(turns);
    const glm::dvec2 point = piece.curve.at(t);
    const glm::dvec2 slope = piece.curve.slope(t);

    const double bow = 4.0 * t * (1.0 - t);
    const double fade = bow * bow;
    const double fadeSlope = 8.0 * bow * (1.0 - 2.0 * t);
    const double wave = piece.flutes.depth * cosTurns(piece.flutes.count * turns);
    const double waveSlope = -piece.flutes.depth * piece.flutes.count * sinTurns(piece.flutes.count * turns);

    const double swell = 1.0 + fade * wave;
    const double radius = point.x * swell;
    const double radiusByT = slope.x * swell + point.x * fadeSlope * wave;

    // dP/dθ over r: it has a direction at the poles too, where dP/dθ itself is zero.
    const double sideways = fade * waveSlope;
    const glm::dvec3 alongU(sideways * sine + swell * cosine, 0.0, sideways * cosine - swell * sine);
    const glm::dvec3 alongV(radiusByT * sine, slope.y, radiusByT * cosine);

    mesh.positions.push_back(snap({radius * sine, point.y, radius * cosine}));
    mesh.normals.emplace_back(glm::normalize(glm::cross(alongV, alongU)));
    mesh.tangents.emplace_back(glm::dvec4(glm::normalize(alongU), 1.0));
}

} // namespace

glm::vec3 snap(glm::dvec3 position) {
    const auto round = [](double x) { return static_cast<float>(std::floor(x * 4096.0 + 0.5) / 4096.0); };
    return {round(position.x), round(position.y), round(position.z)};
}

void appendGrid(Mesh& mesh, std::size_t first, int rows, int columns) {
    const auto appendTriangle = [&mesh](std::size_t a, std::size_t b, std::size_t c) {
        const auto& p = mesh.positions;
        if (p[a] == p[b] || p[b] == p[c] || p[c] == p[a])
            return;
        for (const std::size_t index : {a, b, c})
            mesh.indices.push_back(static_cast<std::uint16_t>(index));
    };
    assert(mesh.positions.size() <= 65535);
    const std::size_t stride = static_cast<std::size_t>(columns) + 1;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const std::size_t corner = first + static_cast<std::size_t>(row) * stride + column;
            appendTriangle(corner, corner + stride, corner + 1);
            appendTriangle(corner + 1, corner + stride, corner + stride + 1);
        }
}

Mesh turn(const Profile& profile, const Turning& turning) {
    Mesh mesh;
    const int columns = turning.sectors * turning.segments;
    for (std::size_t i = 0; i < profile.pieces().size(); ++i) {
        const Piece& piece = profile.pieces()[i];
        for (int sector = 0; sector < turning.sectors; ++sector) {
            const std::size_t first = mesh.positions.size();
            for (int row = 0; row <= piece.rings; ++row)
                for (int segment = 0; segment <= turning.segments; ++segment) {
                    const double t = double(row) / piece.rings;
                    const int column = sector * turning.segments + segment;
                    appendVertex(mesh, piece, t, double(column) / columns);
                    mesh.uvs.emplace_back(double(segment) / turning.segments, profile.v(i, t));
                }
            appendGrid(mesh, first, piece.rings, turning.segments);
        }
    }
    return mesh;
}

} // namespace make_model
