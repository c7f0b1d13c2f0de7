// SPDX-License-Identifier: MIT
#include "franken/platform/rotation.h"

#include <gtest/gtest.h>

namespace franken::platform {
namespace {

constexpr Rotation kRotations[] = {Rotation::None, Rotation::Quarter, Rotation::Half,
                                   Rotation::ThreeQuarters};

/// Where a point of the viewer's picture is on the panel, and thus on its sensor: by the matrix that turns
/// the picture.
Point onPanel(Point viewer, Rotation rotation) {
    const std::array<float, 16> clip = clipRotation(rotation);
    const double x = 2 * viewer.x - 1, y = 1 - 2 * viewer.y;
    return {(clip[0] * x + clip[4] * y + 1) / 2, (1 - clip[1] * x - clip[5] * y) / 2};
}

TEST(Rotation, ATouchIsFeltWhereThePictureIsTouched) {
    for (const Rotation rotation : kRotations)
        for (const Point seen : {Point{0, 0}, {1, 0}, {0.25, 0.75}, {0.5, 0.125}})
            EXPECT_EQ(toViewer(onPanel(seen, rotation), rotation), seen) << toDegrees(rotation);
}

// A panel that stands on its left side: what was its left edge is below, and its top edge is at the left.
TEST(Rotation, AQuarterIsClockwise) {
    EXPECT_EQ(toViewer({0, 0}, Rotation::Quarter), (Point{1, 0}))
        << "its upper left corner is at the upper right";
    EXPECT_EQ(toViewer({0, 1}, Rotation::Quarter), (Point{0, 0}))
        << "its lower left corner is at the upper left";
    EXPECT_EQ(turned({1920, 1080}, Rotation::Quarter), (Size{1080, 1920}));
    EXPECT_EQ(turned({1920, 1080}, Rotation::Half), (Size{1920, 1080}));
}

TEST(Rotation, HasDegreesAndTheKernelsWords) {
    for (const Rotation rotation : kRotations)
        EXPECT_EQ(rotationOf(toDegrees(rotation)), rotation);
    EXPECT_EQ(rotationOfOrientation("Left Side Up"), Rotation::Quarter);
    EXPECT_EQ(rotationOfOrientation("Upside Down"), Rotation::Half);
    EXPECT_EQ(rotationOfOrientation("Right Side Up"), Rotation::ThreeQuarters);
    EXPECT_EQ(rotationOf(45), std::nullopt);
}

} // namespace
} // namespace franken::platform
