// SPDX-License-Identifier: MIT
#include "franken/rotation.h"

#include <cstddef>

namespace franken {
namespace {

struct RotationRow {
    int degrees;
    /// Of a turn counter-clockwise by so many degrees.
    float cosine, sine;
};

/// In the order of the enumeration.
constexpr RotationRow kRotations[] = {{0, 1, 0}, {90, 0, 1}, {180, -1, 0}, {270, 0, -1}};

const RotationRow& rowOf(Rotation rotation) { return kRotations[static_cast<std::size_t>(rotation)]; }

} // namespace

int toDegrees(Rotation rotation) { return rowOf(rotation).degrees; }

std::optional<Rotation> rotationOf(int degrees) {
    for (const Rotation rotation :
         {Rotation::None, Rotation::Quarter, Rotation::Half, Rotation::ThreeQuarters})
        if (rowOf(rotation).degrees == degrees)
            return rotation;
    return std::nullopt;
}

bool swapsAxes(Rotation rotation) {
    return rotation == Rotation::Quarter || rotation == Rotation::ThreeQuarters;
}

std::array<float, 16> clipRotation(Rotation rotation) {
    const auto& [degrees, cosine, sine] = rowOf(rotation);
    return {cosine, sine, 0, 0, -sine, cosine, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
}

} // namespace franken
