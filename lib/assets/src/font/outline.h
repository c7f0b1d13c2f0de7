// SPDX-License-Identifier: MIT
#pragma once

#include "font/tables.h"

#include <cstdint>
#include <vector>

namespace franken {

struct OutlinePoint {
    float x = 0, y = 0;  ///< Units of the em, y upwards from the baseline.
    bool onCurve = true; ///< Else it controls a quadratic curve between its neighbours.
};

/// The closed contours of a glyph.
struct Outline {
    std::vector<OutlinePoint> points;
    std::vector<std::size_t> ends; ///< Behind the last point of each contour, increasing.
};

/// No glyph of Debian's fonts has a fifth of these.
inline constexpr std::size_t kMaxOutlinePoints = 16384, kMaxOutlineParts = 256;
inline constexpr int kMaxOutlineDepth = 8;

/// Empty for a glyph without contours. Fails with "font.glyph" where its bytes are broken, or ask for more
/// points or parts than the limits. (OpenType 1.9, "glyf")
Result<Outline> readOutline(const FontTables& tables, std::uint16_t glyph);

} // namespace franken
