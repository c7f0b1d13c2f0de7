// SPDX-License-Identifier: MIT
// When the kiosk is dark, what wakes it, what it does without, and what buttons do. In virtual time.
#include "kiosk/vm_kiosk.h"
#include "support/other_master.h"
#include "support/service_manager.h"
#include "support/shell.h"
#include "support/sim_chip.h"
#include "support/uinput.h"

#include <linux/input-event-codes.h>
#include <poll.h>
#include <unistd.h>
#include <xf86drm.h>

#include <csignal>
#include <ctime>
#include <thread>
#include <tuple>

namespace franken::test {
namespace {

using namespace std::chrono_literals;

const std::string kContent = "[content]\nfolder = \"models\"\nseconds = 0\n";
const std::string kStill = kContent + "[show]\nturn-seconds = 0\n"; // Draws only what changes.

class KioskLife : public KioskInGuest {
protected:
    void SetUp() override {
        KioskInGuest::SetUp();
        if (!IsSkipped()) {
            setenv("TZ", "UTC", 1);
            copyModel(kBox, "a.glb");
            copyModel(kBox, "b.glb");
        }
    }
    /// For so long, the watchdog is fed as often at least, and the state is told.
    static void expectFed(const FakeServiceManager& manager, const std::string& state,
                          std::chrono::milliseconds time, int times) {
        int alive = 0;
        bool isSaid = false;
        pollfd ready{manager.descriptor(), POLLIN, 0};
        for (const auto end = std::chrono::steady_clock::now() + time;
             std::chrono::steady_clock::now() < end;) {
            poll(&ready, 1, 100);
            for (std::string message = manager.next(); !message.empty(); message = manager.next()) {
                alive += message.find("WATCHDOG=1") != std::string::npos ? 1 : 0;
                isSaid = isSaid || message.find(state) != std::string::npos;
            }
        }
        EXPECT_GE(alive, times) << state;
        EXPECT_TRUE(isSaid) << state;
    }
    /// Sets the machine's clock: a Monday.
    static void setClock(int hour, int minute, int second) {
        const timespec time{1'771'200'000 - 1'771'200'000 % 86'400 + hour * 3600 + minute * 60 + second, 0};
        ASSERT_EQ(clock_settime(CLOCK_REALTIME, &time), 0);
        const std::tm* const local = gmtime(&time.tv_sec);
        ASSERT_EQ(local->tm_wday, 1) << "not a Monday";
    }
};

TEST_F(KioskLife, OpeningHoursAreHeededOnceTheClockIsSynchronised) {
    setClock(8, 59, 30);
    start(kContent + "[timetable]\nmonday = [\"09:00-18:00\"]\n");
    ASSERT_TRUE(logs("shows"));
    EXPECT_EQ(log().find("dark"), std::string::npos) << "who knows what time it is";
    writeMachine("/run/systemd/timesync/synchronized", "");
    ASSERT_TRUE(logs("the screen is dark: closed", 2));
    ASSERT_TRUE(logs("blanked"));
    ASSERT_TRUE(logs("the screen wakes", 40));
    ASSERT_TRUE(logs("drawing", 1));
    setClock(17, 59, 59);
    EXPECT_FALSE(logs("dark", 0));
    ASSERT_TRUE(logs("the screen is dark: closed", 2));
    setClock(12, 0, 0); // A jump, which nothing announces but the kernel.
    ASSERT_TRUE(logs("the screen wakes", 1));
    setClock(23, 0, 0);
    ASSERT_TRUE(logs("the screen is dark: closed", 1));
}

TEST_F(KioskLife, MotionAndKeysWakeItAndIdleTimeDoesNotPassWhileSomebodyIsThere) {
    const SimChip chip;
    chip.pull(23, false);
    const UinputDevice keys(UinputDevice::Kind::Keyboard, "kiosk keys");
    start(kStill + "[presence]\npin = 23\nidle-minutes = 1\n");
    ASSERT_TRUE(logs("shows"));
    std::this_thread::sleep_for(2s);
    const double frames = metric("frame_duration_seconds_count");
    ASSERT_TRUE(logs("the screen is dark: nobody is there", 62));
    EXPECT_LE(metric("frame_duration_seconds_count"), frames + 2) << "nothing moves but the caption";
    chip.pull(23, true);
    ASSERT_TRUE(logs("the screen wakes", 1));
    EXPECT_FALSE(logs("the screen is dark", 90)) << "somebody stands there";
    chip.pull(23, false);
    ASSERT_TRUE(logs("the screen is dark: nobody is there", 62));
    keys.key(KEY_A, true);
    keys.key(KEY_A, false);
    ASSERT_TRUE(logs("the screen wakes", 1));
}

TEST_F(KioskLife, AnHourWithoutAScreenAndTheWatchdogIsFedInEachState) {
    const FakeServiceManager manager(10s);
    start(kStill);
    const auto fed = [&manager](const std::string& state) { expectFed(manager, state, 20s, 4); };
    fed("drawing");
    plug("off");
    fed("no screen");
    std::this_thread::sleep_for(1h);
    plug("detect");
    fed("drawing");
    {
        const int screen = screenDescriptor(kiosk().process());
        ASSERT_EQ(drmDropMaster(screen), 0);
        close(screen);
        const OtherMaster thief;
        kiosk().signal(SIGHUP); // Whoever draws nothing does not notice.
        fed("paused");
    }
    fed("drawing");
    writeConfig(kStill + "[presence]\nidle-minutes = 0.01\n");
    fed("blanked");
    kiosk().signal(SIGTERM);
    EXPECT_EQ(kiosk().wait(), 0);
}

TEST_F(KioskLife, TheWatchdogIsFedWhileTheKernelRefusesFrames) {
    const FakeServiceManager manager(200ms);
    const std::string faults = (folder() / "faults").string();
    setenv("FRANKEN_FAULTS", faults.c_str(), 1);
    start(kStill, FAULTY_KIOSK);
    ASSERT_TRUE(logs("shows"));
    writeFile(faults, "commit");
    kiosk().signal(SIGHUP);
    expectFed(manager, "recovering", 400ms, 4); // After 620 ms it would end.
    std::filesystem::remove(faults);
    unsetenv("FRANKEN_FAULTS");
    expectFed(manager, "drawing", 400ms, 4);
    EXPECT_TRUE(kiosk().runs());
}

TEST_F(KioskLife, LittleContiguousMemoryMeansOneModelAtATime) {
    writeMachine("/proc/meminfo", "CmaTotal: 262144 kB\nCmaFree: 131072 kB\n");
    start("[content]\nfolder = \"models\"\nseconds = 3\n");
    ASSERT_TRUE(logs("b.glb"));
    writeMachine("/proc/meminfo", "CmaTotal: 262144 kB\nCmaFree: 8192 kB\n");
    ASSERT_TRUE(logs("too little contiguous memory", 5));
    ASSERT_TRUE(logs("a.glb", 10));
    ASSERT_TRUE(logs("b.glb", 10));
    writeConfig(kStill);
    writeMachine("/proc/meminfo", "CmaTotal: 262144 kB\nCmaFree: 131072 kB\n");
    ASSERT_TRUE(logs("relief 0", 130));
    writeConfig("[content]\nfolder = \"models\"\nseconds = 3\n");
    ASSERT_TRUE(logs("a.glb", 10));
}

TEST_F(KioskLife, HeatLowersResolutionAndRateStepByStepAndAStillPicturesStatisticsGoOn) {
    const std::string sensor = "/sys/class/thermal/thermal_zone0/temp";
    writeMachine(sensor, "50000\n");
    start(kStill + "statistics = true\n");
    ASSERT_TRUE(logs("shows"));
    std::this_thread::sleep_for(2s);
    const auto model = [](const VmPicture& shown) { // Below the statistics, above the caption.
        std::vector<std::uint32_t> pixels;
        for (int y = shown.size.height * 13 / 20; y < shown.size.height * 16 / 20; ++y)
            for (int x = shown.size.width / 2; x < shown.size.width * 3 / 4; ++x)
                pixels.push_back(shown.at(x, y));
        return pixels;
    };
    const auto cool = model(picture("kiosk_cool"));
    writeMachine(sensor, "85000\n");
    ASSERT_TRUE(logs("relief 1 of 4: 75 % of the resolution", 15));
    ASSERT_TRUE(logs("relief 4 of 4: 50 % of the resolution, 25 % of the frame rate", 40));
    std::this_thread::sleep_for(2s);
    EXPECT_NE(model(picture("kiosk_hot")), cool) << "its edges are stretched";
    const double frames = metric("frame_duration_seconds_count");
    EXPECT_EQ(metric("relief_step"), 4);
    EXPECT_EQ(metric("temperature_celsius"), 85);
    EXPECT_GT(metric("frame_duration_seconds_count"), frames + 20) << "one each second";
    writeMachine(sensor, "50000\n");
    ASSERT_TRUE(logs("relief 3 of 4", 125));
}

TEST_F(KioskLife, TheDoctorSeesTheScreenItsRendererAndWhoHoldsIt) {
    const Outcome before = runIn(folder(), KIOSK " doctor --json");
    EXPECT_EQ(before.code, 1) << before.out << before.err;
    EXPECT_NE(before.out.find("connected, prefers"), std::string::npos) << before.out;
    EXPECT_NE(before.out.find("the processor draws"), std::string::npos) << before.out;
    EXPECT_EQ(before.out.find("held by"), std::string::npos) << before.out;
    start(kStill);
    ASSERT_TRUE(logs("shows"));
    const Outcome during = runIn(folder(), KIOSK " doctor --json");
    EXPECT_NE(during.out.find("held by kiosk (" + std::to_string(kiosk().process()) + ")"), std::string::npos)
        << during.out;
}

TEST_F(KioskLife, ButtonsAndKeysDoWhatTheConfigurationSays) {
    copyModel(kBox, "c.glb");
    const SimChip chip;
    chip.pull(17, true);
    const UinputDevice keys(UinputDevice::Kind::Keyboard, "kiosk keys");
    start(kContent +
          "[buttons]\nnext = [\"GPIO17\"]\npause = [\"GPIO17:long\"]\n[keys]\nprevious = [\"x\"]\n");
    ASSERT_TRUE(logs("a.glb"));
    const auto press = [&chip](std::chrono::milliseconds held) {
        chip.pull(17, false);
        std::this_thread::sleep_for(held);
        chip.pull(17, true);
    };
    press(100ms);
    ASSERT_TRUE(logs("asked for: next"));
    ASSERT_TRUE(logs("b.glb"));
    press(1500ms);
    ASSERT_TRUE(logs("asked for: pause"));
    std::this_thread::sleep_for(2s);
    const VmPicture paused = picture("kiosk_paused");
    std::this_thread::sleep_for(2s);
    EXPECT_TRUE(picture("kiosk_paused_still") == paused);
    keys.key(KEY_X, true);
    keys.key(KEY_X, false);
    ASSERT_TRUE(logs("asked for: previous"));
    ASSERT_TRUE(logs("a.glb"));
    for (const char* after : {"b.glb", "c.glb"}) { // Forwards again.
        press(100ms);
        ASSERT_TRUE(logs("asked for: next"));
        ASSERT_TRUE(logs(after));
    }
    keys.key(KEY_X, true);
    keys.key(KEY_X, false);
    ASSERT_TRUE(logs("b.glb"));
}

TEST_F(KioskLife, KeysChangeThePictureAndBackAndFingersTurnZoomAndSwipe) {
    const UinputDevice screen(UinputDevice::Kind::TouchScreen, "kiosk touch");
    const UinputDevice keys(UinputDevice::Kind::Keyboard, "kiosk keys");
    start(kStill + "pixel-shift = 0\n");
    ASSERT_TRUE(logs("a.glb"));
    std::this_thread::sleep_for(2s);
    const VmPicture still = picture("kiosk_touch_still");
    const auto pressed = [&](int key, const std::string& action) { // Not "asked for: screenshot" of before.
        keys.key(key, true);
        keys.key(key, false);
        EXPECT_TRUE(logs("asked for: " + action));
        return picture("kiosk_key_" + std::to_string(key));
    };
    for (const auto& [there, done, back, undone] : {std::tuple{KEY_L, "lights", KEY_L, "lights"},
                                                    {KEY_UP, "brighter", KEY_DOWN, "darker"},
                                                    {KEY_N, "caption", KEY_N, "caption"}}) {
        EXPECT_FALSE(pressed(there, done) == still) << done;
        EXPECT_TRUE(pressed(back, undone) == still) << undone;
    }
    screen.touch(0, 300, 500, true);
    for (int x = 320; x <= 600; x += 20) {
        std::this_thread::sleep_for(20ms);
        screen.touch(0, x, 500, false);
    }
    screen.release(0);
    std::this_thread::sleep_for(2s);
    const VmPicture turned = picture("kiosk_touch_turned");
    EXPECT_FALSE(turned == still);
    screen.touch(0, 450, 500, true);
    screen.touch(1, 550, 500, true);
    for (int way = 10; way <= 200; way += 10) {
        std::this_thread::sleep_for(20ms);
        screen.touch(0, 450 - way, 500, false);
        screen.touch(1, 550 + way, 500, false);
    }
    screen.release(0);
    screen.release(1);
    std::this_thread::sleep_for(2s);
    EXPECT_GT(brightShare(picture("kiosk_touch_near")), 1.2 * brightShare(turned));
    screen.touch(0, 700, 400, true);
    screen.touch(1, 700, 600, true);
    for (int way = 20; way <= 400; way += 20) {
        std::this_thread::sleep_for(20ms);
        screen.touch(0, 700 - way, 400, false);
        screen.touch(1, 700 - way, 600, false);
    }
    screen.release(0);
    screen.release(1);
    ASSERT_TRUE(logs("asked for: next"));
    ASSERT_TRUE(logs("b.glb"));
}

} // namespace
} // namespace franken::test
