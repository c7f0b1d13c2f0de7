// SPDX-License-Identifier: MIT
#include "franken/platform/rotation.h"

#include <utility>

namespace franken::platform {

namespace {

struct RotationRow {
    int degrees;
    std::string_view orientation;
    /// Of a turn counter-clockwise by so many degrees.
    float cosine, sine;
};

/// In the order of the enumeration.
constexpr RotationRow kRotations[] = {{0, "Normal", 1, 0},
                                      {90, "Left Side Up", 0, 1},
                                      {180, "Upside Down", -1, 0},
                                      {270, "Right Side Up", 0, -1}};

const RotationRow& rowOf(Rotation rotation) { return kRotations[static_cast<std::size_t>(rotation)]; }

template<typename Matches>
std::optional<Rotation> find(Matches matches) {
    for (const Rotation rotation :
         {Rotation::None, Rotation::Quarter, Rotation::Half, Rotation::ThreeQuarters})
        if (matches(rowOf(rotation)))
            return rotation;
    return std::nullopt;
}

} // namespace

int toDegrees(Rotation rotation) { return rowOf(rotation).degrees; }

std::optional<Rotation> rotationOf(int degrees) {
    return find([&](const RotationRow& row) { return row.degrees == degrees; });
}

std::optional<Rotation> rotationOfOrientation(std::string_view orientation) {
    return find([&](const RotationRow& row) { return row.orientation == orientation; });
}

Size turned(Size size, Rotation rotation) {
    if (rotation == Rotation::Quarter || rotation == Rotation::ThreeQuarters)
        std::swap(size.width, size.height);
    return size;
}

std::array<float, 16> clipRotation(Rotation rotation) {
    const auto& [degrees, orientation, cosine, sine] = rowOf(rotation);
    return {cosine, sine, 0, 0, -sine, cosine, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
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
