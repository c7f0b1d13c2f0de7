// SPDX-License-Identifier: MIT
//
// What a screen can go through, against a fake of the kernel's calls: what vkms in a guest cannot be made to
// do.
#include "platform/fake_kms.h"

#include <gtest/gtest.h>

namespace franken::platform {
namespace {

using namespace std::chrono_literals;
using Strings = std::vector<std::string>;

class KmsScreenTest : public testing::Test {
protected:
    void open(const ScreenOptions& options = {}) {
        screen = std::make_unique<KmsScreen>(device, buffers, options, 4096, Log());
        screen->update(now);
    }
    /// Lets time pass, with ticks when they are due.
    void pass(Nanoseconds time) {
        const Nanoseconds end = now + time;
        while (screen->deadline() && *screen->deadline() <= end) {
            now = *screen->deadline();
            screen->tick(now);
        }
        now = end;
    }
    std::optional<CompletedFrame> flip(std::uint32_t sequence) {
        device.answer(sequence, now);
        return screen->readFlips(now);
    }

    FakeKms device;
    FakeBuffers buffers;
    Nanoseconds now{1s};
    std::unique_ptr<KmsScreen> screen;
};

TEST_F(KmsScreenTest, SetsTheModeOnceAndFlipsThen) {
    open();
    ASSERT_EQ(screen->state(), SurfaceState::Ready) << screen->status();
    EXPECT_EQ(screen->layout().mode.buffer, (Size{1920, 1080}));
    screen->present(11, now);
    EXPECT_EQ(screen->state(), SurfaceState::Busy);
    EXPECT_TRUE(flip(5));
    screen->present(12, now);
    EXPECT_TRUE(flip(6));
    EXPECT_EQ(device.modesets, 1);
    EXPECT_EQ(device.flips, 1);
    EXPECT_EQ(buffers.released, (std::vector<std::uint32_t>{11}));
    EXPECT_TRUE(device.framebuffers.empty()) << "a tried framebuffer was left";
    EXPECT_EQ(device.blobs.size(), 1u);
    screen.reset();
    EXPECT_TRUE(device.blobs.empty());
}

TEST_F(KmsScreenTest, TakesAFlipOfAnEarlierFrameForNone) {
    open();
    screen->present(11, now);
    device.answers.push_back({device.lastFrame - 1, 4, now});
    EXPECT_FALSE(screen->readFlips(now));
    EXPECT_EQ(screen->state(), SurfaceState::Busy);
}

class RetriedError : public KmsScreenTest, public testing::WithParamInterface<int> {};
INSTANTIATE_TEST_SUITE_P(Errno, RetriedError, testing::Values(EBUSY, ENOSPC, ENOMEM));

TEST_P(RetriedError, IsTriedAgainThenTheScreenIsResetThenItEnds) {
    open();
    device.errors = {-GetParam()};
    screen->present(11, now);
    EXPECT_EQ(screen->state(), SurfaceState::Recovering);
    pass(10ms);
    EXPECT_EQ(screen->state(), SurfaceState::Busy) << "the frame was not tried again";
    EXPECT_TRUE(flip(1));
    EXPECT_EQ(device.offs, 0);

    device.errors.assign(6, -GetParam()); // Each try fails; the one after the reset does not.
    screen->present(12, now);
    pass(1s);
    EXPECT_EQ(device.offs, 1);
    EXPECT_EQ(screen->state(), SurfaceState::Busy) << screen->status();
    EXPECT_TRUE(flip(2));

    device.errors.assign(40, -GetParam());
    screen->present(13, now);
    pass(1s);
    ASSERT_EQ(screen->state(), SurfaceState::Failed);
    EXPECT_EQ(screen->failure().code, "screen.commit");
}

TEST_F(KmsScreenTest, FallsAStepWhereACommitIsInvalid) {
    open();
    device.errors = {-EINVAL};
    screen->present(11, now);
    EXPECT_EQ(screen->state(), SurfaceState::Ready);
    EXPECT_EQ(buffers.tried, (Strings{"1920x1080 8888 tiled", "1920x1080 8888 linear"}));
    EXPECT_EQ(buffers.released, (std::vector<std::uint32_t>{11}));
}

TEST_F(KmsScreenTest, WalksDownFormatsModifiersAndModes) {
    device.test = [](const KmsBuffer& buffer) {
        const bool good = buffer.size.width == 1280 && buffer.modifier == DRM_FORMAT_MOD_INVALID;
        return good ? 0 : -EINVAL;
    };
    open({.format = PixelFormat::Rgb565});
    ASSERT_EQ(screen->state(), SurfaceState::Ready) << screen->status();
    EXPECT_EQ(buffers.tried, (Strings{"1920x1080 565 linear", "1920x1080 565 none", "1920x1080 8888 tiled",
                                      "1920x1080 8888 linear", "1920x1080 8888 none", "1280x720 565 linear",
                                      "1280x720 565 none"}));
}

TEST_F(KmsScreenTest, EndsWhereNothingIsTaken) {
    device.test = [](const KmsBuffer&) { return -EINVAL; };
    open();
    ASSERT_EQ(screen->state(), SurfaceState::Failed);
    EXPECT_EQ(screen->failure().code, "screen.no-layout");
}

TEST_F(KmsScreenTest, ScalesABufferWhereEveryModeIsTooLarge) {
    open({.maxPixels = 640 * 360});
    ASSERT_EQ(screen->state(), SurfaceState::Ready);
    EXPECT_EQ(screen->layout().mode.mode.hdisplay, 1920);
    EXPECT_EQ(screen->layout().mode.buffer, (Size{640, 360}));
}

TEST_F(KmsScreenTest, LeavesOutModesThatExceedTheLimit) {
    open({.maxPixels = 1280 * 720});
    EXPECT_EQ(screen->layout().mode.mode.hdisplay, 1280);
}

TEST_F(KmsScreenTest, WaitsForTheMasterThatStole) {
    open();
    device.master = device.masterIsFree = false;
    screen->present(11, now);
    EXPECT_EQ(screen->state(), SurfaceState::Paused);
    pass(10s);
    EXPECT_EQ(screen->state(), SurfaceState::Paused);
    device.masterIsFree = true;
    pass(1s);
    EXPECT_EQ(screen->state(), SurfaceState::Ready);
    screen->present(11, now);
    EXPECT_EQ(device.modesets, 1) << "it has to set the mode again";
}

TEST_F(KmsScreenTest, TellsThatTheDeviceIsGone) {
    open();
    device.errors = {-ENODEV};
    screen->present(11, now);
    EXPECT_TRUE(screen->deviceLost());
    EXPECT_EQ(screen->state(), SurfaceState::NoScreen);
}

TEST_F(KmsScreenTest, SwitchesOffAndOnWhenAFlipIsNotAnsweredAndEndsTheSecondTime) {
    open();
    screen->present(11, now);
    pass(4999ms);
    EXPECT_EQ(device.offs, 0);
    pass(1ms);
    EXPECT_EQ(device.offs, 1);
    EXPECT_EQ(screen->state(), SurfaceState::Busy);
    pass(5s);
    ASSERT_EQ(screen->state(), SurfaceState::Failed);
    EXPECT_EQ(screen->failure().code, "screen.flip-timeout");
}

TEST_F(KmsScreenTest, GivesTheScreenAwayAfterTheFlip) {
    open();
    screen->present(11, now);
    screen->pause(now);
    EXPECT_TRUE(device.master);
    EXPECT_TRUE(flip(1));
    EXPECT_EQ(screen->state(), SurfaceState::Paused);
    EXPECT_FALSE(device.master);
    pass(10s);
    EXPECT_EQ(screen->state(), SurfaceState::Paused) << "it took the screen back unasked";
    screen->resume(now);
    EXPECT_EQ(screen->state(), SurfaceState::Ready);
}

TEST_F(KmsScreenTest, BlanksAndWakes) {
    open();
    for (const Blanking blanking : {Blanking::Black, Blanking::Off}) {
        screen->blank(blanking, now);
        EXPECT_EQ(screen->state(), SurfaceState::Blanked);
        screen->blank(Blanking::None, now);
        EXPECT_EQ(screen->state(), SurfaceState::Ready);
        screen->present(11, now);
        EXPECT_TRUE(flip(1)) << "the flip that proves it";
    }
    EXPECT_EQ(device.offs, 1);
}

TEST_F(KmsScreenTest, TakesAConnectorOfUnknownStatusWhereNothingIsConnected) {
    KmsConnector composite = device.resources.connectors[0];
    composite.id = 9;
    composite.name = "Composite-1";
    composite.connection = Connection::Unknown;
    device.resources.connectors.push_back(composite);
    open();
    EXPECT_TRUE(screen->status().starts_with("HDMI-A-1")) << screen->status();
    device.resources.connectors[0].connection = Connection::Disconnected;
    screen->update(now);
    EXPECT_TRUE(screen->status().starts_with("Composite-1")) << screen->status();
}

TEST_F(KmsScreenTest, TakesAnAssumedScreenWithItsModeline) {
    device.resources.connectors[0].connection = Connection::Disconnected;
    device.resources.connectors[0].modes.clear();
    open({.output = "HDMI-A-1",
          .assumeConnected = true,
          .modeline = parseModeline("33.750 800 840 888 976 480 483 493 500 -hsync +vsync").value()});
    ASSERT_EQ(screen->state(), SurfaceState::Ready) << screen->status();
    EXPECT_EQ(screen->layout().mode.buffer, (Size{800, 480}));
}

TEST_F(KmsScreenTest, TurnsThePictureAsThePanelIsMounted) {
    KmsProperty orientation;
    orientation.choices = {{"Normal", 0}, {"Right Side Up", 3}};
    orientation.value = 3;
    device.resources.connectors[0].properties["panel orientation"] = orientation;
    open();
    EXPECT_EQ(screen->layout().rotation, Rotation::ThreeQuarters);
}

TEST_F(KmsScreenTest, CountsAFrameThatCameLate) {
    open();
    screen->present(11, now);
    flip(100);
    screen->frameBegun(now + 1ms);
    screen->present(12, now);
    EXPECT_EQ(flip(101)->missed, 0);
    screen->frameBegun(now + 1ms);
    screen->present(13, now);
    EXPECT_EQ(flip(103)->missed, 1);
}

} // namespace
} // namespace franken::platform
