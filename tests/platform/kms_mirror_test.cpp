// SPDX-License-Identifier: MIT
//
// A second output that shows the same picture, against a fake of the kernel's calls.
#include "platform/fake_kms.h"

#include <gtest/gtest.h>

namespace franken::platform {
namespace {

using namespace std::chrono_literals;

constexpr std::uint32_t kFirst = 2, kSecond = 12; ///< CRTCs.

class KmsMirrorTest : public testing::Test {
protected:
    KmsMirrorTest() { device.addOutput({fakeMode(1280, 720, true), fakeMode(1920, 1080, false)}); }

    void open(const ScreenOptions& options = {.mirror = "HDMI-A-2"}) {
        screen = std::make_unique<KmsScreen>(device, buffers, options, 4096, Log());
        screen->update(now);
    }
    std::optional<CompletedFrame> flip(std::uint32_t crtc, std::uint32_t sequence) {
        device.answer(sequence, now, crtc);
        return screen->readFlips(now);
    }
    const KmsConnector& connector(std::size_t output) const { return device.resources.connectors[output]; }
    std::optional<std::uint64_t> plane(std::size_t output, const std::string& property) const {
        return device.wasSet(device.resources.planes[output], property);
    }

    FakeKms device;
    FakeBuffers buffers;
    Nanoseconds now{1s};
    std::unique_ptr<KmsScreen> screen;
};

TEST_F(KmsMirrorTest, ShowsTheSameBufferInTheSameCommitAtItsOwnSize) {
    open();
    EXPECT_EQ(screen->status(), "HDMI-A-1 1920x1080@60 8888, mirrored on HDMI-A-2 1920x1080@60");
    screen->present(77, now);
    EXPECT_EQ(device.modesets, 1);
    EXPECT_EQ(device.wasSet(connector(0), "CRTC_ID"), kFirst);
    EXPECT_EQ(device.wasSet(connector(1), "CRTC_ID"), kSecond);
    for (const std::size_t output : {0u, 1u}) {
        EXPECT_EQ(plane(output, "FB_ID"), 77u);
        EXPECT_EQ(plane(output, "CRTC_W"), 1920u);
        EXPECT_EQ(plane(output, "CRTC_H"), 1080u);
    }
    EXPECT_EQ(device.blobs.size(), 2u);
    screen.reset();
    EXPECT_TRUE(device.blobs.empty());
}

TEST_F(KmsMirrorTest, AFrameIsCompletedWhenBothShowItByTheFirstScreensClock) {
    open();
    screen->present(11, now);
    EXPECT_FALSE(flip(kFirst, 100));
    EXPECT_EQ(screen->state(), SurfaceState::Busy);
    now += 5ms;
    const std::optional<CompletedFrame> completed = flip(kSecond, 7);
    ASSERT_TRUE(completed);
    EXPECT_EQ(completed->sequence, 100u);
    EXPECT_EQ(completed->nanoseconds, (now - 5ms).count());
    EXPECT_EQ(screen->state(), SurfaceState::Ready);
    screen->present(12, now);
    EXPECT_FALSE(flip(kSecond, 8));
    EXPECT_TRUE(flip(kFirst, 101));
    EXPECT_EQ(device.flips, 1);
    EXPECT_EQ(buffers.released, (std::vector<std::uint32_t>{11}));
}

TEST_F(KmsMirrorTest, KeepsThePicturesShapeOnAnotherScreen) {
    device.resources.connectors[1].modes = {fakeMode(1024, 768, true)};
    open();
    screen->present(11, now);
    EXPECT_EQ(plane(1, "SRC_W"), std::uint64_t{1920} << 16);
    EXPECT_EQ(plane(1, "CRTC_X"), 0u);
    EXPECT_EQ(plane(1, "CRTC_W"), 1024u);
    EXPECT_EQ(plane(1, "CRTC_H"), 576u); // 1024 * 1080 / 1920
    EXPECT_EQ(plane(1, "CRTC_Y"), 96u);
    device.resources.connectors[1].modes = {fakeMode(800, 480, true)};
    open();
    screen->present(12, now);
    EXPECT_EQ(plane(1, "CRTC_W"), 800u);
    EXPECT_EQ(plane(1, "CRTC_H"), 450u);
    device.resources.connectors[1].modes = {fakeMode(2560, 1080, true)};
    open();
    screen->present(13, now);
    EXPECT_EQ(plane(1, "CRTC_W"), 1920u);
    EXPECT_EQ(plane(1, "CRTC_X"), 320u);
}

TEST_F(KmsMirrorTest, IsPluggedInAndOutWithoutANewLayout) {
    KmsConnector& second = device.resources.connectors[1];
    second.connection = Connection::Disconnected;
    open();
    EXPECT_EQ(screen->status(),
              "HDMI-A-1 1920x1080@60 8888, not mirrored on HDMI-A-2 (no screen is connected)");
    screen->present(11, now);
    ASSERT_TRUE(flip(kFirst, 1));
    EXPECT_FALSE(device.wasSet(second, "CRTC_ID"));

    const int layouts = screen->layoutCount();
    second.connection = Connection::Connected;
    screen->update(now);
    screen->present(12, now);
    EXPECT_EQ(device.modesets, 2);
    EXPECT_EQ(device.wasSet(second, "CRTC_ID"), kSecond);
    EXPECT_FALSE(flip(kFirst, 2));
    EXPECT_TRUE(flip(kSecond, 1));

    second.connection = Connection::Disconnected;
    screen->update(now);
    EXPECT_EQ(device.offs, 1) << "its CRTC is left on";
    screen->present(13, now);
    EXPECT_TRUE(flip(kFirst, 3));
    EXPECT_EQ(screen->layoutCount(), layouts);
    EXPECT_EQ(device.blobs.size(), 1u);
}

TEST_F(KmsMirrorTest, TheFirstScreenIsNeverTheOneThatMirrors) {
    open({.mirror = "HDMI-A-1"});
    EXPECT_EQ(screen->status(), "HDMI-A-2 1280x720@60 8888, mirrored on HDMI-A-1 1280x720@60");
    device.resources.connectors[1].connection = Connection::Disconnected;
    screen->update(now);
    EXPECT_EQ(screen->state(), SurfaceState::NoScreen);
    EXPECT_EQ(device.offs, 1);
}

TEST_F(KmsMirrorTest, TheFirstScreenGoesOnWhereTheMirrorIsRefused) {
    device.testRequest = [&](const KmsRequest& request) {
        for (const KmsAssignment& set : request)
            if (set.object == kSecond)
                return -EINVAL;
        return 0;
    };
    open();
    EXPECT_EQ(screen->status(),
              "HDMI-A-1 1920x1080@60 8888, not mirrored on HDMI-A-2 (the driver refuses every mode)");
    screen->present(11, now);
    EXPECT_TRUE(flip(kFirst, 1));
    EXPECT_EQ(device.blobs.size(), 1u);
}

class RefusedMirror : public KmsMirrorTest, public testing::WithParamInterface<int> {};
INSTANTIATE_TEST_SUITE_P(Errno, RefusedMirror, testing::Values(EINVAL, ENOSPC));

TEST_P(RefusedMirror, IsGivenUpBeforeThePicture) {
    open();
    device.errors.assign(GetParam() == EINVAL ? 1 : 6, -GetParam());
    screen->present(11, now);
    while (screen->deadline() && screen->state() == SurfaceState::Recovering) {
        now = *screen->deadline();
        screen->tick(now);
    }
    if (screen->state() == SurfaceState::Ready)
        screen->present(12, now);
    EXPECT_TRUE(flip(kFirst, 1)) << screen->status();
    EXPECT_EQ(screen->status(),
              "HDMI-A-1 1920x1080@60 8888, not mirrored on HDMI-A-2 (the driver refuses it)");
    screen->update(now); // Something was plugged: it may be taken now.
    EXPECT_TRUE(screen->status().ends_with("mirrored on HDMI-A-2 1920x1080@60")) << screen->status();
}

TEST_F(KmsMirrorTest, ItsUnansweredFlipDoesNotEndThePicture) {
    open();
    screen->present(11, now);
    EXPECT_FALSE(flip(kFirst, 1));
    now = *screen->deadline();
    screen->tick(now);
    EXPECT_TRUE(flip(kFirst, 2)) << screen->status();
    EXPECT_EQ(screen->state(), SurfaceState::Ready);
}

TEST_F(KmsMirrorTest, ItsBadLinkIsSetAgain) {
    open();
    screen->present(11, now);
    flip(kFirst, 1);
    flip(kSecond, 1);
    device.resources.connectors[1].properties["link-status"].value = 1;
    screen->update(now);
    screen->present(12, now);
    EXPECT_EQ(device.modesets, 2);
}

TEST_F(KmsMirrorTest, BothAreMadeDarkAndWake) {
    open();
    screen->present(11, now);
    flip(kFirst, 1);
    flip(kSecond, 1);
    screen->blank(Blanking::Black, now);
    EXPECT_EQ(plane(0, "FB_ID"), 99u);
    EXPECT_EQ(plane(1, "FB_ID"), 99u);
    screen->blank(Blanking::Off, now);
    EXPECT_EQ(device.offs, 1);
    screen->blank(Blanking::None, now);
    screen->present(12, now);
    EXPECT_FALSE(flip(kFirst, 2));
    EXPECT_TRUE(flip(kSecond, 2));
}

} // namespace
} // namespace franken::platform
