// SPDX-License-Identifier: MIT
//
// Touch and keys by libinput and systemd-udevd, from devices of uinput. In virtual time.
#include "franken/platform/console.h"
#include "franken/platform/input.h"
#include "support/guest.h"
#include "support/uinput.h"

#include <fcntl.h>
#include <linux/input.h>
#include <poll.h>
#include <termios.h>

#include <cstdlib>
#include <filesystem>
#include <thread>

namespace franken::test {
namespace {

using namespace std::chrono_literals;
using namespace platform;
using Kind = UinputDevice::Kind;

std::string describe(const TouchEvent& touch) {
    constexpr const char* kKinds[] = {"down", "move", "up", "cancel"};
    char text[64];
    std::snprintf(text, sizeof text, "%s%d(%.2f,%.2f)", kKinds[static_cast<int>(touch.kind)], touch.finger,
                  touch.position.x, touch.position.y);
    return text;
}

std::string describe(const KeyEvent& key) { return (key.down ? "key" : "nokey") + std::to_string(key.key); }
std::string describe(const PointerEvent&) { return "pointer"; }
std::string describe(const DeviceEvent& device) {
    return std::string(device.plugged ? "+" : "-") + (device.touch ? "touch" : "") +
           (device.keyboard ? "keyboard" : "");
}

class InputTest : public GuestTest {
protected:
    void SetUp() override {
        GuestTest::SetUp();
        needs("/lib/systemd/systemd-udevd", "udev");
    }
    static std::unique_ptr<Input> open(const InputOptions& options = {}) {
        Result<std::unique_ptr<Input>> input = Input::open(options);
        EXPECT_TRUE(input) << toString(input.error());
        return *std::move(input);
    }
    /// What comes within a moment, in words.
    static std::string events(Input& input) {
        std::string all;
        const auto end = std::chrono::steady_clock::now() + 100ms;
        for (auto now = end - 100ms; now < end; now = std::chrono::steady_clock::now()) {
            pollfd ready = {input.descriptor(), POLLIN, 0};
            poll(&ready, 1, static_cast<int>((end - now) / 1ms) + 1);
            for (const InputEvent& event : input.dispatch())
                all += (all.empty() ? "" : " ") +
                       std::visit([](const auto& one) { return describe(one); }, event);
        }
        return all;
    }
};

TEST_F(InputTest, DevicesComeAndGoAtAnyTime) {
    const UinputDevice before(Kind::Keyboard, "before");
    const auto input = open();
    EXPECT_EQ(events(*input), "+keyboard");
    for (int time = 0; time < 3; ++time) {
        const UinputDevice screen(Kind::TouchScreen, "screen");
        EXPECT_EQ(events(*input), time == 0 ? "+touch" : "-touch +touch");
        before.key(KEY_LEFT, true);
        before.key(KEY_LEFT, false);
        EXPECT_EQ(events(*input), "key105 nokey105");
        screen.touch(0, 250, 500, true);
        screen.release(0);
        EXPECT_EQ(events(*input), "down0(0.25,0.50) up0(0.25,0.50)");
    }
    EXPECT_EQ(events(*input), "-touch");
}

TEST_F(InputTest, FingersAreToldApart) {
    const UinputDevice screen(Kind::TouchScreen, "screen");
    const auto input = open();
    events(*input);
    screen.touch(0, 100, 200, true);
    screen.touch(1, 700, 800, true);
    screen.touch(0, 100, 300, false);
    screen.release(0);
    EXPECT_EQ(events(*input), "down0(0.10,0.20) down1(0.70,0.80) move0(0.10,0.30) up0(0.10,0.30)");
    screen.touch(0, 400, 400, true);
    EXPECT_EQ(events(*input), "down0(0.40,0.40)");
}

TEST_F(InputTest, OpenTouchesAreCancelledWhenTheDeviceGoes) {
    const auto input = open();
    std::optional<UinputDevice> screen(std::in_place, Kind::TouchScreen, "screen");
    EXPECT_EQ(events(*input), "+touch");
    screen->touch(0, 100, 200, true);
    screen->touch(1, 700, 800, true);
    EXPECT_EQ(events(*input), "down0(0.10,0.20) down1(0.70,0.80)");
    screen.reset();
    EXPECT_EQ(events(*input), "cancel0(0.10,0.20) cancel1(0.70,0.80) -touch");
}

/// Where a touch at (0.25, 0.125) of the sensor is for the viewer, when the sensor is turned clockwise.
Point seen(Rotation rotation) {
    constexpr Point kSeen[] = {{0.25, 0.125}, {0.875, 0.25}, {0.75, 0.875}, {0.125, 0.75}};
    return kSeen[static_cast<int>(rotation)];
}

constexpr Rotation kRotations[] = {Rotation::None, Rotation::Quarter, Rotation::Half,
                                   Rotation::ThreeQuarters};

struct Mounted {
    Rotation screen;
    std::optional<Rotation> touch;
};

std::vector<Mounted> allMounted() {
    std::vector<Mounted> all;
    for (const Rotation screen : kRotations) {
        all.push_back({screen, std::nullopt});
        for (const Rotation touch : kRotations)
            all.push_back({screen, touch});
    }
    return all;
}

Point touchedAt(Input& input, const UinputDevice& screen) {
    screen.touch(0, 250, 125, true);
    screen.release(0);
    std::this_thread::sleep_for(20ms);
    for (const InputEvent& event : input.dispatch())
        if (const auto* touch = std::get_if<TouchEvent>(&event))
            return touch->position;
    ADD_FAILURE() << "no touch came";
    return {};
}

void expectNear(Point found, Point wanted) {
    EXPECT_NEAR(found.x, wanted.x, 0.002);
    EXPECT_NEAR(found.y, wanted.y, 0.002);
}

TEST_F(InputTest, ATouchIsWhereTheViewerSeesItForEachRotationOfPictureAndSensor) {
    const UinputDevice screen(Kind::TouchScreen, "screen");
    for (const auto& [picture, sensor] : allMounted()) {
        SCOPED_TRACE(std::to_string(toDegrees(picture)) + ", " +
                     (sensor ? std::to_string(toDegrees(*sensor)) : "as the picture"));
        const auto input = open({.screen = picture, .touch = sensor});
        expectNear(touchedAt(*input, screen), seen(sensor.value_or(picture)));
        input->setScreenRotation(Rotation::Half);
        expectNear(touchedAt(*input, screen), seen(sensor.value_or(Rotation::Half)));
    }
}

/// A rule of udev's for as long as it lives.
class CalibrationRule {
public:
    explicit CalibrationRule(const std::string& matrix) {
        std::filesystem::create_directories("/run/udev/rules.d");
        writeFile(kFile, "SUBSYSTEM==\"input\", ENV{LIBINPUT_CALIBRATION_MATRIX}=\"" + matrix + "\"\n");
        reload();
    }
    ~CalibrationRule() {
        std::filesystem::remove(kFile);
        reload();
    }

private:
    static void reload() { EXPECT_EQ(std::system("udevadm control --reload"), 0); }
    static constexpr const char* kFile = "/run/udev/rules.d/99-calibration.rules";
};

TEST_F(InputTest, WhatUdevSaysOfTheSensorIsAppliedOnce) {
    const CalibrationRule quarter("0 -1 1 1 0 0"); // Clockwise, as its documentation has it.
    const UinputDevice screen(Kind::TouchScreen, "screen");
    expectNear(touchedAt(*open(), screen), seen(Rotation::Quarter));
    expectNear(touchedAt(*open({.screen = Rotation::Quarter}), screen), seen(Rotation::Half));
    for (const Rotation touch : kRotations)
        expectNear(touchedAt(*open({.screen = Rotation::Half, .touch = touch}), screen), seen(touch));
}

TEST_F(InputTest, GrabbedDevicesAreReadByNobodyElse) {
    const UinputDevice keyboard(Kind::Keyboard, "keyboard");
    const int other = ::open(keyboard.node().c_str(), O_RDONLY | O_NONBLOCK);
    ASSERT_GE(other, 0);
    const auto reads = [&] {
        input_event event;
        bool any = false;
        while (read(other, &event, sizeof event) == static_cast<ssize_t>(sizeof event))
            any = true;
        return any;
    };
    for (const bool grab : {false, true}) {
        const auto input = open({.grab = grab});
        events(*input);
        keyboard.key(KEY_A, true);
        keyboard.key(KEY_A, false);
        EXPECT_EQ(events(*input), "key30 nokey30");
        EXPECT_EQ(reads(), !grab);
    }
    keyboard.key(KEY_A, true);
    EXPECT_TRUE(reads()) << "it is still grabbed";
    close(other);
}

/// The login shell's end of the console that is shown: raw, so that each key is read at once.
class Shell {
public:
    Shell() : m_console(::open("/dev/tty1", O_RDWR | O_NONBLOCK | O_NOCTTY)) {
        termios raw = {};
        tcgetattr(m_console, &raw);
        cfmakeraw(&raw);
        tcsetattr(m_console, TCSANOW, &raw);
        std::this_thread::sleep_for(20ms);
        tcflush(m_console, TCIFLUSH); // What the tests before typed.
    }
    ~Shell() { close(m_console); }
    std::string typed() const {
        char text[64];
        const ssize_t bytes = read(m_console, text, sizeof text);
        return bytes > 0 ? std::string(text, static_cast<std::size_t>(bytes)) : std::string();
    }

private:
    int m_console;
};

void type(const UinputDevice& keyboard, std::initializer_list<unsigned> keys) {
    for (const unsigned key : keys) {
        keyboard.key(key, true);
        keyboard.key(key, false);
    }
    std::this_thread::sleep_for(20ms);
}

TEST_F(InputTest, KeysDoNotReachTheConsoleAndDoAgainAfterwards) {
    if (!std::filesystem::exists("/dev/vcs1"))
        GTEST_SKIP()
            << "the guest's kernel has no virtual consoles: tests/vm/kernel/build.sh makes one that has";
    const UinputDevice keyboard(Kind::Keyboard, "keyboard");
    const Shell shell;
    type(keyboard, {KEY_L, KEY_S});
    EXPECT_EQ(shell.typed(), "ls");
    {
        const auto console = Console::open("/dev/tty1");
        ASSERT_TRUE(console) << toString(console.error());
        const auto input = open();
        events(*input);
        type(keyboard, {KEY_R, KEY_M, KEY_ENTER});
        EXPECT_EQ(shell.typed(), "") << "the shell behind the kiosk runs what is typed into it";
        EXPECT_EQ(events(*input), "key19 nokey19 key50 nokey50 key28 nokey28");
    }
    type(keyboard, {KEY_L, KEY_S});
    EXPECT_EQ(shell.typed(), "ls");
}

} // namespace
} // namespace franken::test
