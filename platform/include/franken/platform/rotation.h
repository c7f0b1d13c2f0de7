// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/result.h"
#include "franken/rotation.h"

#include <optional>
#include <string_view>

namespace franken {
namespace FRANKEN_API platform {

/// A size in pixels.
struct Size {
    int width = 0;  ///< Pixels.
    int height = 0; ///< Pixels.
    bool operator==(const Size&) const = default;
};

using franken::clipRotation;
using franken::Rotation;
using franken::rotationOf;
using franken::toDegrees;

/// The rotation of the kernel's panel orientation: "Normal", "Left Side Up", "Upside Down" or "Right Side
/// Up".
std::optional<Rotation> rotationOfOrientation(std::string_view orientation);

/// The size of a turned target, as the viewer sees it: width and height change places for Quarter and
/// ThreeQuarters.
Size turned(Size size, Rotation rotation);

/// A place on a screen, in shares of it.
struct Point {
    double x = 0; ///< 0 at the left, 1 at the right.
    double y = 0; ///< 0 at the top, 1 at the bottom.
    bool operator==(const Point&) const = default;
};

/// Converts a point from a sensor's own frame to the viewer's.
Point toViewer(Point sensor, Rotation rotation);

} // namespace platform
} // namespace franken
