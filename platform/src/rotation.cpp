// SPDX-License-Identifier: MIT
#include "franken/platform/rotation.h"

#include <utility>

namespace franken::platform {

namespace {

/// In the order of the enumeration.
constexpr std::string_view kOrientations[] = {"Normal", "Left Side Up", "Upside Down", "Right Side Up"};

} // namespace

std::optional<Rotation> rotationOfOrientation(std::string_view orientation) {
    for (const Rotation rotation :
         {Rotation::None, Rotation::Quarter, Rotation::Half, Rotation::ThreeQuarters})
        if (kOrientations[static_cast<std::size_t>(rotation)] == orientation)
            return rotation;
    return std::nullopt;
}

Size turned(Size size, Rotation rotation) {
    if (swapsAxes(rotation))
        std::swap(size.width, size.height);
    return size;
}

Point toViewer(Point sensor, Rotation rotation) {
    switch (rotation) {
    case Rotation::None:
        return sensor;
    case Rotation::Quarter:
        return {1 - sensor.y, sensor.x};
    case Rotation::Half:
        return {1 - sensor.x, 1 - sensor.y};
    case Rotation::ThreeQuarters:
        return {sensor.y, 1 - sensor.x};
    }
    return sensor;
}

} // namespace franken::platform
