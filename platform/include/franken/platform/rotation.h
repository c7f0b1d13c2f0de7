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

/// How far a panel (or a touch sensor) is turned clockwise from the way it was made, as its viewer sees it.
/// The picture is turned the other way in it. The kernel's `panel orientation` in these words: "Left Side Up"
/// is Quarter, "Upside Down" is Half, "Right Side Up" is ThreeQuarters.
enum class Rotation { None, Quarter, Half, ThreeQuarters };

/// Degrees clockwise: 0, 90, 180 or 270.
int toDegrees(Rotation rotation);

/// The inverse of toDegrees(); nothing for other numbers.
std::optional<Rotation> rotationOf(int degrees);

/// As the kernel names a panel's orientation: "Normal", "Left Side Up", "Upside Down" or "Right Side Up".
std::optional<Rotation> rotationOfOrientation(std::string_view orientation);

/// What the viewer has before him when a target of that size is turned: width and height change places for
/// Quarter and ThreeQuarters.
Size turned(Size size, Rotation rotation);

/// From clip space as the viewer sees it to clip space of the panel: what the projection is multiplied with
/// from the left. Column-major, as GL has it.
std::array<float, 16> clipRotation(Rotation rotation);

struct Point {
    double x = 0; ///< 0 at the left, 1 at the right.
    double y = 0; ///< 0 at the top, 1 at the bottom.
    bool operator==(const Point&) const = default;
};

/// From a sensor's own frame to the viewer's.
Point toViewer(Point sensor, Rotation rotation);

} // namespace platform
} // namespace franken
