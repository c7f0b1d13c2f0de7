// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model.h"
#include "profile.h"

namespace make_model {

/// A stretch of a bar that is bent in the plane z = 0.
struct Bend {
    Bezier path;       ///< Metres.
    double radiusFrom; ///< Thickness at its two ends, metres; between them it changes evenly in t.
    double radiusTo;
    int rings = 12; ///< Rows of quads along the path.
};

/// A round bar along bends that follow each other, with normals that allow for curvature and taper but
/// without tangents and texture coordinates. A bend's radius has to stay below its radius of curvature.
/// `around` is the number of quads around the bar.
Mesh sweep(const std::vector<Bend>& bends, int around);

} // namespace make_model
