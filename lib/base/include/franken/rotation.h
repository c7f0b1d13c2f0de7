// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"

#include <array>
#include <optional>

namespace FRANKEN_API franken {

/// How far a panel (or a touch sensor) is turned clockwise from its native orientation, as its viewer sees
/// it. The picture is turned the other way. The kernel's `panel orientation` "Left Side Up" is Quarter,
/// "Upside Down" is Half, "Right Side Up" is ThreeQuarters.
enum class Rotation { None, Quarter, Half, ThreeQuarters };

/// Degrees clockwise: 0, 90, 180 or 270.
int toDegrees(Rotation rotation);

/// The inverse of toDegrees(); nothing for other numbers.
std::optional<Rotation> rotationOf(int degrees);

/// Whether width and height change places.
bool swapsAxes(Rotation rotation);

/// From clip space as the viewer sees it to clip space of the panel: what the projection is multiplied with
/// from the left. Column-major, as GL has it.
std::array<float, 16> clipRotation(Rotation rotation);

} // namespace franken
