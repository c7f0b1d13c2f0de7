// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/result.h"

#include <array>
#include <optional>
#include <string_view>

namespace franken {
namespace FRANKEN_API platform {

struct Size {
    int width = 0;  ///< Pixels.
    int height = 0; ///< Pixels.
    bool operator==(const Size&) const = default;
};

/// How far a panel (or a touch sensor) is turned clockwise from its native orientation, as its viewer sees
/// it. The picture is turned the other way. The kernel's `panel orientation` "Left Side Up" is Quarter,
/// "Upside Down" is Half, "Right Side Up" is ThreeQuarters.
enum class Rotation { None, Quarter, Half, ThreeQuarters };

/// Degrees clockwise: 0, 90, 180 or 270.
int toDegrees(Rotation rotation);

/// The inverse of toDegrees(); nothing for other numbers.
std::optional<Rotation> rotationOf(int degrees);

/// The rotation of the kernel's panel orientation: "Normal", "Left Side Up", "Upside Down" or "Right Side
/// Up".
std::optional<Rotation> rotationOfOrientation(std::string_view orientation);

/// The size of a turned target, as the viewer sees it: width and height change places for Quarter and
/// ThreeQuarters.
Size turned(Size size, Rotation rotation);

/// The matrix from the viewer's clip space to the panel's: multiply the projection by it from the left.
/// Column-major, as in GL.
std::array<float, 16> clipRotation(Rotation rotation);

struct Point {
    double x = 0; ///< 0 at the left, 1 at the right.
    double y = 0; ///< 0 at the top, 1 at the bottom.
    bool operator==(const Point&) const = default;
};

/// Converts a point from a sensor's own frame to the viewer's.
Point toViewer(Point sensor, Rotation rotation);

} // namespace platform
} // namespace franken
