// SPDX-License-Identifier: MIT
#include "kiosk/show/view.h"

#include <gtest/gtest.h>

namespace franken::test {
namespace {

using kiosk::Config;
using kiosk::View;

Config configOf(const std::string& camera) {
    Config config;
    config.show.camera = camera;
    config.show.turnSeconds = 8;
    return config;
}

View viewOf(int cameras, const std::string& camera) {
    Scene still;
    for (int i = 0; i < cameras; ++i)
        still.cameras.push_back({.name = "camera " + std::to_string(i), .index = i});
    return {std::move(still), {.min = {-1, -1, -1}, .max = {1, 1, 1}}, 1.5, configOf(camera)};
}

TEST(KioskView, LooksThroughTheFilesCamerasOnlyWhereTheConfigurationSaysSo) {
    View view = viewOf(2, "orbit");
    EXPECT_EQ(view.camera().index, kNone);
    view.configure(configOf("file"));
    EXPECT_EQ(view.camera().name, "camera 0") << "at once";
    EXPECT_EQ(viewOf(2, "file").camera().name, "camera 0");
    EXPECT_EQ(viewOf(0, "file").camera().index, kNone) << "a file without cameras is looked at from outside";
    view.configure(configOf("orbit"));
    EXPECT_EQ(view.camera().index, kNone);
}

TEST(KioskView, TheNextCameraIsOneOfTheFileAndThenTheOrbitAgain) {
    View view = viewOf(2, "file");
    view.nextCamera();
    EXPECT_EQ(view.camera().name, "camera 1");
    view.configure(configOf("file"));
    EXPECT_EQ(view.camera().name, "camera 1") << "what a visitor chose outlives a changed configuration";
    view.nextCamera();
    EXPECT_EQ(view.camera().index, kNone);
    view.nextCamera();
    EXPECT_EQ(view.camera().name, "camera 0");
}

TEST(KioskView, OnlyTheOrbitTurns) {
    View view = viewOf(1, "file");
    const Camera before = view.camera();
    view.advance(2);
    EXPECT_EQ(view.camera().world, before.world);
    EXPECT_FALSE(view.moves());
    view.configure(configOf("orbit"));
    view.advance(4);
    EXPECT_TRUE(view.moves());
    const Camera orbit = view.camera();
    view.advance(2);
    EXPECT_NE(view.camera().world, orbit.world);
    view.setPaused(true);
    view.advance(10); // Until the damping has settled.
    const Camera paused = view.camera();
    view.advance(10);
    EXPECT_EQ(view.camera().world, paused.world);
    EXPECT_FALSE(view.moves());
}

} // namespace
} // namespace franken::test
