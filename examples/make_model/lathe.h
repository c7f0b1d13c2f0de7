// SPDX-License-Identifier: MIT
#pragma once

#include "model.h"
#include "profile.h"

namespace make_model {

/// How finely, and how often around, a profile is turned.
struct Turning {
    int sectors = 1;   ///< Times that u runs from 0 to 1 around the whole turn: the texture repeats.
    int segments = 48; ///< Columns of quads in one sector.
};

/// A surface of revolution about +Y, with normals, tangents and texture coordinates from the derivatives of
///
///     P(t, θ) = (R sin θ, y(t), R cos θ),   R = r(t) · (1 + flutes(t, θ)).
///
/// Seen from outside u runs to the right and v down. T is dP/dθ; N is dP/dt × dP/dθ, outward for a profile
/// from the top down; hence cross(N, T) points up, towards smaller v, where the green of a normal texture
/// points in glTF: w = +1 everywhere. Each piece has end rings of its own, so creases between pieces are
/// sharp, and pieces whose curves agree in slope are smooth. Each sector has end columns of its own.
/// Positions are multiples of 1/4096 m: the bounds in the JSON text are then short and exact.
Mesh turn(const Profile& profile, const Turning& turning);

/// A coordinate rounded to a multiple of 1/4096, as a float, exactly.
glm::vec3 snap(glm::dvec3 position);

/// Appends the triangles of a grid of vertices, `rows` × `columns` quads, whose first vertex is `first` and
/// whose rows run to the right and follow each other downwards. Triangles without area are left out.
void appendGrid(Mesh& mesh, std::size_t first, int rows, int columns);

} // namespace make_model
