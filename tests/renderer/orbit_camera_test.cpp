// SPDX-License-Identifier: MIT
// A camera that goes round a point: what is dragged, its limits, and how it comes to rest.
#include "franken/orbit_camera.h"
#include "franken/viewpoint.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace franken::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Box box() { return {{-1, 0, -2}, {3, 2, 2}}; }

/// At (1, 1, 10), looks at the centre of the box.
OrbitCamera ahead(Camera::Projection projection = Camera::Projection::Perspective) {
    Camera camera;
    camera.projection = projection;
    camera.znear = 0.5f;
    camera.zfar = 50;
    camera.world[3] = glm::dvec4(1, 1, 10, 1);
    return OrbitCamera(camera, box());
}

double difference(const glm::dmat4& a, const glm::dmat4& b) {
    double most = 0;
    for (int column = 0; column < 4; ++column)
        most = std::max(most, glm::distance(a[column], b[column]));
    return most;
}

TEST(OrbitCamera, BeginsWhereTheCameraStands) {
    const Camera framing = framingCamera(box(), 1.5);
    EXPECT_LT(difference(OrbitCamera(framing, box()).camera().world, framing.world), 1e-12);
    const OrbitCamera camera = ahead();
    EXPECT_LT(glm::distance(camera.orbit().target, {1, 1, 0}), 1e-12);
    EXPECT_NEAR(camera.orbit().distance, 10, 1e-12);
    Camera above;
    above.world = glm::inverse(glm::lookAt(glm::dvec3(1, 9, 0), glm::dvec3(1, 1, 0), glm::dvec3(0, 0, -1)));
    const OrbitCamera down(above, box());
    EXPECT_NEAR(down.orbit().pitch, kPi / 2, 1e-7) << "straight down, which has an up as well";
    EXPECT_LT(difference(down.camera().world, above.world), 1e-6);
    Camera away; // What it could go round is behind it.
    away.world[3] = glm::dvec4(1, 1, -10, 1);
    EXPECT_GT(OrbitCamera(away, box()).orbit().distance, 0.2);
    EXPECT_GT(OrbitCamera({}, {}).orbit().distance, 0.2);
}

TEST(OrbitCamera, GoesWhereItIsDragged) {
    OrbitCamera camera = ahead();
    ASSERT_TRUE(camera.drag(-0.5, 0)); // A quarter of a turn: the scene to the left, the camera to the right.
    ASSERT_TRUE(camera.advance(0.01));
    EXPECT_LT(glm::distance(glm::dvec3(camera.camera().world[3]), {11, 1, 0}), 1e-9);
    ASSERT_TRUE(camera.drag(0, 1.0 / 6)); // 30 degrees: the scene down, the camera up.
    ASSERT_TRUE(camera.advance(0.01));
    EXPECT_NEAR(camera.camera().world[3].y, 1 + 10 * 0.5, 1e-9);
    ASSERT_TRUE(camera.zoom(0.5));
    ASSERT_TRUE(camera.advance(0.01));
    EXPECT_NEAR(camera.camera().world[3].y, 1 + 5 * 0.5, 1e-9);
    ASSERT_TRUE(camera.moveTo({.target = {0, 0, 0}, .yaw = 0, .pitch = 0, .distance = 2}));
    ASSERT_TRUE(camera.advance(0.01));
    EXPECT_LT(difference(camera.camera().world, glm::translate(glm::dmat4(1), {0, 0, 2})), 1e-12);
}

TEST(OrbitCamera, LooksAtItsTarget) {
    OrbitCamera camera = ahead();
    for (const double pitch : {-kPi / 2, -0.4, 0.0, 1.0, kPi / 2})
        for (const double yaw : {-3.0, 0.5, 8.0}) {
            ASSERT_TRUE(camera.moveTo({.target = {1, 2, 3}, .yaw = yaw, .pitch = pitch, .distance = 4}));
            ASSERT_TRUE(camera.advance(1));
            const Camera seen = camera.camera();
            EXPECT_NEAR(glm::determinant(glm::dmat3(seen.world)), 1, 1e-12);
            const glm::dvec4 target = viewpointOf(seen, 1).viewProjection * glm::dvec4(1, 2, 3, 1);
            EXPECT_LT(glm::length(glm::dvec2(target)), 1e-9);
            EXPECT_NEAR(target.w, 4, 1e-9);
        }
}

TEST(OrbitCamera, ComesToRestWhateverTheFrameRate) {
    const auto after = [](double frame, int frames) {
        OrbitCamera camera = ahead();
        EXPECT_TRUE(camera.setDamping(0.2));
        EXPECT_TRUE(camera.drag(0.3, 0.1));
        EXPECT_TRUE(camera.zoom(3));
        for (int i = 0; i < frames; ++i)
            EXPECT_TRUE(*camera.advance(frame));
        return camera;
    };
    const OrbitCamera once = after(0.5, 1), often = after(0.001, 500);
    EXPECT_LT(difference(once.camera().world, often.camera().world), 1e-9);
    const double rest = std::exp(-2.5);
    EXPECT_NEAR(once.orbit().yaw, -0.3 * kPi * (1 - rest), 1e-12);
    EXPECT_NEAR(once.orbit().distance, 10 * std::pow(3, 1 - rest), 1e-9);
}

TEST(OrbitCamera, SaysWhetherThePictureChanges) {
    OrbitCamera camera = ahead();
    ASSERT_TRUE(camera.setDamping(0.1));
    EXPECT_TRUE(*camera.advance(0)) << "the first one has not been drawn";
    EXPECT_FALSE(*camera.advance(0.1));
    ASSERT_TRUE(camera.drag(0.2, 0));
    int frames = 0;
    while (*camera.advance(1.0 / 60))
        ++frames;
    EXPECT_GT(frames, 30);
    EXPECT_LT(frames, 120);
    EXPECT_EQ(camera.orbit().yaw, camera.goal().yaw);
    EXPECT_FALSE(*camera.advance(100));
}

TEST(OrbitCamera, StaysWithinItsLimits) {
    OrbitCamera camera = ahead();
    ASSERT_TRUE(camera.setDamping(0.1));
    const OrbitLimits limits{.minYaw = -1,
                             .maxYaw = 0.5,
                             .minPitch = 0.1,
                             .maxPitch = 1,
                             .minDistance = 4,
                             .maxDistance = 8,
                             .targets = {{0, 0, 0}, {0.5, 0.5, 0.5}}};
    ASSERT_TRUE(camera.setLimits(limits));
    const auto isInside = [&](const Orbit& orbit) {
        return orbit.yaw >= -1 && orbit.yaw <= 0.5 && orbit.pitch >= 0.1 && orbit.pitch <= 1 &&
               orbit.distance >= 4 - 1e-12 && orbit.distance <= 8 + 1e-12 && orbit.target.x <= 0.5 &&
               orbit.target.y <= 0.5;
    };
    EXPECT_TRUE(isInside(camera.orbit())) << "at once";
    for (const auto& [x, y, factor] : {std::tuple(3.0, 5.0, 100.0), {-7.0, -9.0, 1e-5}, {0.1, 0.1, 1e300}}) {
        ASSERT_TRUE(camera.drag(x, y));
        ASSERT_TRUE(camera.zoom(factor));
        ASSERT_TRUE(camera.moveTo(
            {camera.goal().target + x, camera.goal().yaw, camera.goal().pitch, camera.goal().distance}));
        for (int frame = 0; frame < 100; ++frame) {
            ASSERT_TRUE(camera.advance(0.01));
            ASSERT_TRUE(isInside(camera.orbit()));
        }
    }
    // What was dragged beyond the limit need not be dragged back.
    ASSERT_TRUE(camera.drag(-100, 0));
    ASSERT_TRUE(camera.drag(0.1, 0));
    EXPECT_LT(camera.goal().yaw, 0.5);
}

TEST(OrbitCamera, ZoomsAnOrthographicCameraByItsHeight) {
    OrbitCamera camera = ahead(Camera::Projection::Orthographic);
    ASSERT_TRUE(camera.zoom(0.25));
    ASSERT_TRUE(camera.advance(0));
    EXPECT_NEAR(camera.camera().ymag, 0.25, 1e-6);
    EXPECT_NEAR(camera.camera().world[3].z, 10, 1e-9) << "it does not enter what it looks at";
    EXPECT_EQ(camera.camera().zfar, 50);
}

TEST(OrbitCamera, ShowsWhatItComesCloseToAndWhatItLeaves) {
    OrbitCamera camera = ahead();
    for (const double factor : {0.01, 1e6}) {
        ASSERT_TRUE(camera.zoom(factor));
        ASSERT_TRUE(camera.advance(0));
        const glm::dvec4 target = viewpointOf(camera.camera(), 1).viewProjection * glm::dvec4(1, 1, 0, 1);
        EXPECT_LT(std::abs(target.z), target.w) << factor;
    }
}

TEST(OrbitCamera, RefusesNumbersThatMakeNoOrbit) {
    OrbitCamera camera = ahead();
    const glm::dmat4 before = camera.camera().world;
    const auto isRefused = [](const Result<void>& result) {
        return !result && result.error().code == "renderer.orbit";
    };
    EXPECT_TRUE(isRefused(camera.drag(kNaN, 0)));
    EXPECT_TRUE(isRefused(camera.drag(0, INFINITY)));
    for (const double factor : {0.0, -1.0, kNaN, double{INFINITY}})
        EXPECT_TRUE(isRefused(camera.zoom(factor))) << factor;
    for (const double time : {-1.0, kNaN}) {
        EXPECT_TRUE(isRefused(camera.setDamping(time)));
        EXPECT_EQ(camera.advance(time).error().code, "renderer.orbit");
    }
    EXPECT_TRUE(isRefused(camera.moveTo({.target = {0, kNaN, 0}})));
    EXPECT_TRUE(isRefused(camera.moveTo({.distance = 0})));
    EXPECT_TRUE(isRefused(camera.setLimits({.minYaw = 1, .maxYaw = 0})));
    EXPECT_TRUE(isRefused(camera.setLimits({.minYaw = kNaN})));
    EXPECT_TRUE(isRefused(camera.setLimits({.maxPitch = 2})));
    EXPECT_TRUE(isRefused(camera.setLimits({.minDistance = 0})));
    EXPECT_TRUE(isRefused(camera.setLimits({.maxDistance = kNaN})));
    EXPECT_TRUE(isRefused(camera.setLimits({.targets = {{0, 1, 0}, {1, 0, 1}}})));
    ASSERT_TRUE(camera.advance(1));
    EXPECT_EQ(camera.camera().world, before);
}

} // namespace
} // namespace franken::test
