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
    device.answers.push_back({device.lastFrame - 1, 4, now, 2});
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

// A pulse of the wrong sign makes a screen roll, or none at all.
TEST(ScreenOptionsTest, AModelinesPulsesHaveTheirSigns) {
    const std::string line = "33.750 800 840 888 976 480 483 493 500 ";
    for (const char* hsync : {"-hsync ", "+hsync "})
        for (const char* vsync : {"-vsync", "+vsync"}) {
            const drm_mode_modeinfo mode = toMode(parseModeline(line + hsync + vsync).value());
            EXPECT_EQ((mode.flags & DRM_MODE_FLAG_PHSYNC) != 0, hsync[0] == '+') << hsync << vsync;
            EXPECT_EQ((mode.flags & DRM_MODE_FLAG_NHSYNC) != 0, hsync[0] == '-') << hsync << vsync;
            EXPECT_EQ((mode.flags & DRM_MODE_FLAG_PVSYNC) != 0, vsync[0] == '+') << hsync << vsync;
            EXPECT_EQ((mode.flags & DRM_MODE_FLAG_NVSYNC) != 0, vsync[0] == '-') << hsync << vsync;
        }
}

TEST_F(KmsScreenTest, TurnsThePictureAsThePanelIsMounted) {
    KmsProperty orientation;
    orientation.choices = {{"Normal", 0}, {"Right Side Up", 3}};
    orientation.value = 3;
    device.resources.connectors[0].properties["panel orientation"] = orientation;
    open();
    EXPECT_EQ(screen->layout().rotation, Rotation::ThreeQuarters);
}

TEST_F(KmsScreenTest, SetsTheRangeOfCodesAndTheMarginsKnowingly) {
    for (const auto& [range, code] :
         {std::pair(RgbRange::Full, 1), {RgbRange::Limited, 2}, {RgbRange::Automatic, 0}}) {
        FakeKms fake;
        KmsScreen limited(fake, buffers, {.range = range, .margins = {1, 2, 3, 4}}, 4096, Log());
        limited.update(now);
        limited.present(11, now);
        const KmsConnector& connector = fake.resources.connectors[0];
        EXPECT_EQ(fake.wasSet(connector, "Broadcast RGB"), code);
        EXPECT_EQ(fake.wasSet(connector, "left margin"), 1u);
        EXPECT_EQ(fake.wasSet(connector, "right margin"), 2u);
        EXPECT_EQ(fake.wasSet(connector, "top margin"), 3u);
        EXPECT_EQ(fake.wasSet(connector, "bottom margin"), 4u);
    }
}

TEST_F(KmsScreenTest, DoesWithoutPropertiesThatTheDriverLacks) {
    KmsConnector& connector = device.resources.connectors[0];
    for (const char* name : {"Broadcast RGB", "left margin", "right margin", "top margin", "bottom margin"})
        connector.properties.erase(name);
    open({.range = RgbRange::Limited, .margins = {1, 1, 1, 1}});
    screen->present(11, now);
    EXPECT_TRUE(flip(1));
}

TEST_F(KmsScreenTest, ShowsTenBitsWherePlaneAndDriverHaveThem) {
    const auto formatOf = [&] {
        open({.format = PixelFormat::Rgb10});
        screen->present(11, now);
        flip(1);
        return screen->layout().format.format;
    };
    EXPECT_EQ(formatOf(), PixelFormat::Rgb8) << "the plane has no XR30";
    EXPECT_FALSE(device.wasSet(device.resources.connectors[0], "max bpc"));
    device.resources.planes[0].formats[DRM_FORMAT_XRGB2101010] = {DRM_FORMAT_MOD_LINEAR};
    EXPECT_EQ(formatOf(), PixelFormat::Rgb10);
    EXPECT_EQ(device.wasSet(device.resources.connectors[0], "max bpc"), 10u);
    device.test = [](const KmsBuffer& buffer) {
        return buffer.format == DRM_FORMAT_XRGB2101010 ? -EINVAL : 0;
    };
    EXPECT_EQ(formatOf(), PixelFormat::Rgb8) << "TEST_ONLY refuses it";
}

TEST_F(KmsScreenTest, AnotherScreenIsSetWithoutARestart) {
    open();
    screen->present(11, now);
    flip(1);
    KmsConnector& connector = device.resources.connectors[0];
    const std::vector<drm_mode_modeinfo> modes = std::exchange(connector.modes, {});
    connector.connection = Connection::Disconnected;
    screen->update(now);
    EXPECT_EQ(screen->state(), SurfaceState::NoScreen);
    connector.connection = Connection::Connected;
    connector.modes = {fakeMode(800, 480, true)};
    const int before = screen->layoutCount();
    screen->update(now);
    ASSERT_EQ(screen->state(), SurfaceState::Ready) << screen->status();
    EXPECT_EQ(screen->layout().mode.buffer, (Size{800, 480}));
    EXPECT_EQ(screen->layoutCount(), before + 1);
    screen->present(12, now);
    EXPECT_TRUE(flip(2));
    EXPECT_EQ(device.modesets, 2);
}

TEST_F(KmsScreenTest, ABadLinkIsSetAgain) {
    open();
    screen->present(11, now);
    flip(1);
    EXPECT_FALSE(screen->wantsFrame());
    device.resources.connectors[0].properties["link-status"].value = 1;
    screen->update(now);
    EXPECT_TRUE(screen->wantsFrame()) << "a still picture would not come back";
    screen->present(12, now);
    EXPECT_TRUE(flip(2));
    EXPECT_EQ(device.modesets, 2);
}

TEST_F(KmsScreenTest, AFrameThatWaitsIsShownAfterAPlug) {
    open();
    device.errors = {-EBUSY};
    screen->present(11, now);
    ASSERT_EQ(screen->state(), SurfaceState::Recovering);
    screen->update(now);
    pass(1s);
    EXPECT_TRUE(flip(1)) << screen->status();
    EXPECT_EQ(screen->shown(), 11u);
    screen->present(12, now);
    flip(2);
    EXPECT_EQ(buffers.released, (std::vector<std::uint32_t>{11})) << "a buffer is lost";
}

TEST_F(KmsScreenTest, AnotherOutputIsSetEvenToTheSameMode) {
    device.addOutput(device.resources.connectors[0].modes);
    open();
    screen->present(11, now);
    flip(1);
    device.resources.connectors[0].connection = Connection::Disconnected;
    screen->update(now);
    ASSERT_EQ(screen->state(), SurfaceState::Ready) << screen->status();
    EXPECT_TRUE(screen->wantsFrame()) << "a still picture would not come to it";
    screen->present(12, now);
    EXPECT_EQ(device.modesets, 2);
}

TEST_F(KmsScreenTest, WantsAFrameAtTheStartAndAfterAResetOrABlanking) {
    open();
    EXPECT_TRUE(screen->wantsFrame());
    screen->present(11, now);
    EXPECT_FALSE(screen->wantsFrame()) << "it is on its way";
    flip(1);
    EXPECT_FALSE(screen->wantsFrame());
    screen->reset(now);
    EXPECT_TRUE(screen->wantsFrame());
    screen->present(12, now);
    flip(2);
    screen->blank(Blanking::Off, now);
    screen->blank(Blanking::None, now);
    EXPECT_EQ(screen->state(), SurfaceState::Ready);
    EXPECT_TRUE(screen->wantsFrame());
}

TEST_F(KmsScreenTest, APanelComesBeforeAPlugUnlessAnotherOutputIsNamed) {
    KmsConnector panel = device.resources.connectors[0];
    panel.id = 8;
    panel.name = "DSI-1";
    device.resources.connectors.push_back(panel);
    open();
    EXPECT_TRUE(screen->status().starts_with("DSI-1")) << screen->status();
    open({.output = "HDMI-A-1"});
    EXPECT_TRUE(screen->status().starts_with("HDMI-A-1")) << screen->status();
    open({.output = "HDMI-A-2"});
    EXPECT_EQ(screen->status(), "no screen is connected to HDMI-A-2");
}

TEST_F(KmsScreenTest, TheCrtcIsOneThatIsPossibleAndServesNobodyElse) {
    const auto addCrtc = [&](std::uint32_t id) {
        KmsObject crtc = device.resources.crtcs[0];
        crtc.id = id;
        KmsPlane plane = device.resources.planes[0];
        plane.id = id + 1;
        plane.possibleCrtcs = 1u << device.resources.crtcs.size();
        device.resources.crtcs.push_back(crtc);
        device.resources.planes.push_back(plane);
    };
    addCrtc(20);
    addCrtc(30);
    KmsConnector other = device.resources.connectors[0];
    other.id = 9;
    other.name = "HDMI-A-2";
    other.properties["CRTC_ID"].value = 20;
    device.resources.connectors.push_back(other);
    device.resources.connectors[0].possibleCrtcs = 0b110;
    device.resources.connectors[0].properties["CRTC_ID"].value = 0; // No encoder is attached: after a boot.
    open();
    screen->present(11, now);
    EXPECT_EQ(device.wasSet(device.resources.connectors[0], "CRTC_ID"), 30u);
}

TEST_F(KmsScreenTest, TurnsThePictureAsTheKernelsCommandLineSays) {
    const auto rotation = [&](const char* line, const ScreenOptions& options = {}) {
        device.commandLine = line;
        open(options);
        return toDegrees(screen->layout().rotation);
    };
    EXPECT_EQ(rotation("root=/dev/mmcblk0p2 video=HDMI-A-1:1280x720@60,rotate=90 quiet"), 90);
    EXPECT_EQ(rotation("video=HDMI-A-2:1280x720@60,rotate=90"), 0) << "another connector's";
    EXPECT_EQ(rotation("video=1280x720,rotate=180"), 180) << "that of all connectors";
    EXPECT_EQ(rotation("video=HDMI-A-1:1280x720 video=1280x720,rotate=180"), 0) << "its own counts";
    EXPECT_EQ(rotation("video=HDMI-A-1:1280x720,rotate=45"), 0);
    EXPECT_EQ(rotation("video=HDMI-A-1:1280x720,rotate=90", {.rotation = Rotation::None}), 0);
    KmsProperty orientation;
    orientation.choices = {{"Left Side Up", 2}};
    orientation.value = 2;
    device.resources.connectors[0].properties["panel orientation"] = orientation;
    EXPECT_EQ(rotation("video=HDMI-A-1:720x1280,rotate=270"), 0) << "both count";
}

TEST_F(KmsScreenTest, CountsAFrameThatCameLate) {
    open();
    screen->present(11, now);
    flip(0); // The first of a mode may be told no number.
    screen->frameBegun(now + 1ms);
    screen->present(10, now);
    EXPECT_EQ(flip(100)->missed, 0);
    screen->frameBegun(now + 1ms);
    screen->present(12, now);
    EXPECT_EQ(flip(101)->missed, 0);
    screen->frameBegun(now + 1ms);
    screen->present(13, now);
    EXPECT_EQ(flip(103)->missed, 1);
    screen->frameBegun(now + 10min); // The screen counts with a clock of its own.
    screen->present(14, now);
    EXPECT_EQ(flip(36'105)->missed, 0);
}

} // namespace
} // namespace franken::platform
