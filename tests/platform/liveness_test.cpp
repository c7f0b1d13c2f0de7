// SPDX-License-Identifier: MIT
//
// The watch, the word with the service manager and the console, against fakes of what they talk to.
#include "franken/platform/backlight.h"
#include "franken/platform/console.h"
#include "franken/platform/heartbeat.h"
#include "franken/platform/service.h"
#include "franken/platform/watch.h"
#include "support/offscreen.h"
#include "support/service_manager.h"
#include "support/shell.h"

#include <linux/kd.h>
#include <linux/vt.h>
#include <unistd.h>

#include <csignal>
#include <map>

namespace franken::platform {
namespace {

using namespace std::chrono_literals;

TEST(Watch, SetsTheScreenAgainAndEndsAtTheNextFault) {
    Watch watch({.frameLimit = 12s});
    watch.submitted(0s);
    EXPECT_EQ(watch.step(11s), Watch::Step::None);
    EXPECT_EQ(watch.step(12s), Watch::Step::ResetScreen);
    EXPECT_EQ(watch.step(13s), Watch::Step::None) << "answered twice";
    watch.canary(false);
    EXPECT_EQ(watch.step(20s), Watch::Step::Exit);
    EXPECT_FALSE(watch.reason().empty());
}

TEST(Watch, ForgetsAFaultOfLongAgoAndHasNothingOverdueWhenIdle) {
    Watch watch({.forgetAfter = 60s});
    watch.canary(false);
    EXPECT_EQ(watch.step(1s), Watch::Step::ResetScreen);
    watch.canary(false);
    EXPECT_EQ(watch.step(62s), Watch::Step::ResetScreen);
    watch.submitted(63s);
    watch.idle();
    EXPECT_EQ(watch.step(1000s), Watch::Step::None);
}

TEST(Watch, AsksOnceInEachIntervalAndNeedsErrorsInARow) {
    Watch watch({.canaryInterval = 60s, .errorLimit = 2});
    EXPECT_TRUE(watch.canaryDue(1s));
    EXPECT_FALSE(watch.canaryDue(60s));
    EXPECT_TRUE(watch.canaryDue(61s));
    watch.error(1280);
    watch.error(0);
    watch.error(1280);
    EXPECT_EQ(watch.step(2s), Watch::Step::None);
    watch.error(1280);
    EXPECT_EQ(watch.step(3s), Watch::Step::ResetScreen);
}

TEST(GpuHealth, SeesALivingCanaryAndLeavesTheStateAlone) {
    const Result<test::Offscreen> target = test::openOffscreen(Backend::EglSurfaceless, {8, 8});
    ASSERT_TRUE(target) << toString(target.error());
    const Gl& gl = target->gl;
    gl.ClearColor(0, 0, 0, 0);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.ClearColor(1, 0, 0, 1);
    gl.Scissor(0, 0, 4, 4);
    gl.Enable(GL_SCISSOR_TEST);
    GpuHealth health(target->surface->getProcAddress());
    for (int minute = 0; minute < 9; ++minute)
        EXPECT_TRUE(health.canaryLives());
    gl.Clear(GL_COLOR_BUFFER_BIT);
    EXPECT_EQ(test::readBack(*target).pixel(1, 6), (test::ReadBack::Pixel{255, 0, 0, 255}));
    EXPECT_EQ(test::readBack(*target).pixel(6, 1), (test::ReadBack::Pixel{0, 0, 0, 0}));
    EXPECT_EQ(health.takeError(), 0u);
    gl.Enable(0);
    EXPECT_EQ(health.takeError(), unsigned{GL_INVALID_ENUM});
}

GetProcAddress healthyFunctions;

TEST(GpuHealth, SeesADeadOne) {
    const Result<test::Offscreen> target = test::openOffscreen(Backend::EglSurfaceless, {8, 8});
    ASSERT_TRUE(target) << toString(target.error());
    healthyFunctions = target->surface->getProcAddress();
    void (*const drawsNothing)(unsigned) = [](unsigned) {};
    GpuHealth health([&](const char* name) {
        return std::string_view(name) == "glClear" ? reinterpret_cast<void*>(drawsNothing)
                                                   : healthyFunctions(name);
    });
    EXPECT_FALSE(health.canaryLives());
}

/// All that came, separated by ";".
std::string received(const test::FakeServiceManager& manager) {
    std::string all;
    for (std::string text = manager.next(); !text.empty(); text = manager.next())
        all.append(text).append(";");
    return all;
}

TEST(ServiceManager, IsToldWhatIsNewOnceAndThatTheLoopTurns) {
    const test::FakeServiceManager manager(200ms);
    ServiceManager service;
    EXPECT_EQ(service.watchdogInterval(), 100ms);
    EXPECT_TRUE(service.ready("drawing"));
    EXPECT_TRUE(service.ready("drawing"));
    EXPECT_EQ(received(manager), "READY=1;STATUS=drawing;");
    EXPECT_TRUE(service.status("HDMI-A-1\n1280x720@60"));
    EXPECT_EQ(received(manager), "STATUS=drawing: HDMI-A-1 1280x720@60;");
    EXPECT_TRUE(service.alive());
    EXPECT_TRUE(service.alive());
    EXPECT_EQ(received(manager), "WATCHDOG=1;");
    usleep(60'000);
    EXPECT_TRUE(service.alive());
    EXPECT_EQ(received(manager), "WATCHDOG=1;");
}

TEST(Heartbeat, IsReplacedAsAWhole) {
    const std::string file = test::emptyTestFolder() / "heartbeat";
    EXPECT_EQ(crc32("123456789", 9), 0xCBF43926u);
    ASSERT_TRUE(writeHeartbeat(file, 7, 0xAB));
    EXPECT_EQ(test::readText(file), "7 000000ab\n");
    for (const char* guess : {".part", ".new", ".tmp", "~"}) {
        std::ofstream(file + ".victim") << "precious";
        std::filesystem::create_symlink(file + ".victim", file + guess);
        ASSERT_TRUE(writeHeartbeat(file, 8, 0xAB));
        EXPECT_EQ(test::readText(file + ".victim"), "precious") << "a planted link is not followed";
    }
    EXPECT_EQ(test::readText(file), "8 000000ab\n");
    EXPECT_EQ(writeHeartbeat("/proc/none/heartbeat", 1, 2).error().code, "heartbeat.file");
}

TEST(Backlight, IsSetInItsOwnRange) {
    const std::filesystem::path folder = test::emptyTestFolder();
    std::filesystem::create_directories(folder / "panel");
    std::ofstream(folder / "panel/max_brightness") << "31\n";
    std::ofstream(folder / "panel/brightness") << "0\n";
    Result<Backlight> light = Backlight::find({}, folder);
    ASSERT_TRUE(light) << toString(light.error());
    EXPECT_TRUE(light->setBrightness(0.5));
    EXPECT_EQ(test::readText(folder / "panel/brightness"), "16\n");
    EXPECT_EQ(light->setBrightness(1.1).error().code, "backlight.range");
    EXPECT_EQ(Backlight::find("other", folder).error().code, "backlight.missing");
}

/// A console that is written down.
struct FakeConsole final : ConsoleCalls {
    struct State {
        int keyboard = K_UNICODE, picture = KD_TEXT, switching = VT_AUTO;
        std::vector<unsigned long> released;
        std::map<unsigned long, int> errors;
    };
    State& state;
    explicit FakeConsole(State& of) : state(of) {}
    int call(unsigned long request, unsigned long argument) override {
        if (const auto error = state.errors.find(request); error != state.errors.end())
            return error->second;
        switch (request) {
        case KDGKBMODE:
            *reinterpret_cast<int*>(argument) = state.keyboard;
            break;
        case KDGETMODE:
            *reinterpret_cast<int*>(argument) = state.picture;
            break;
        case VT_GETMODE:
            reinterpret_cast<vt_mode*>(argument)->mode = static_cast<char>(state.switching);
            break;
        case KDSKBMODE:
            state.keyboard = static_cast<int>(argument);
            break;
        case KDSETMODE:
            state.picture = static_cast<int>(argument);
            break;
        case VT_SETMODE:
            state.switching = reinterpret_cast<vt_mode*>(argument)->mode;
            break;
        case VT_RELDISP:
            state.released.push_back(argument);
            break;
        default:
            return -EINVAL;
        }
        return 0;
    }
};

bool isRestored(const FakeConsole::State& console) {
    return console.keyboard == K_UNICODE && console.picture == KD_TEXT && console.switching == VT_AUTO;
}

TEST(Console, ReadsNoKeysWhileItIsTakenAndIsPutBack) {
    FakeConsole::State fake;
    {
        const auto console = Console::open(std::make_unique<FakeConsole>(fake));
        ASSERT_TRUE(console) << toString(console.error());
        EXPECT_EQ(fake.keyboard, K_OFF);
        EXPECT_EQ(fake.picture, KD_GRAPHICS);
        EXPECT_EQ(fake.switching, VT_PROCESS);
        EXPECT_EQ(Console::open(std::make_unique<FakeConsole>(fake)).error().code, "console.busy");
    }
    EXPECT_TRUE(isRestored(fake));
}

TEST(Console, IsPutRightWhereAKilledProgramLeftItTaken) {
    FakeConsole::State fake{
        .keyboard = K_OFF, .picture = KD_GRAPHICS, .switching = VT_PROCESS, .released = {}, .errors = {}};
    ASSERT_TRUE(Console::open(std::make_unique<FakeConsole>(fake)));
    EXPECT_TRUE(isRestored(fake));
}

TEST(Console, IsPutBackWhereverTakingItFails) {
    for (const unsigned long request : {KDGKBMODE, KDGETMODE, VT_GETMODE, VT_SETMODE, KDSKBMODE, KDSETMODE}) {
        FakeConsole::State fake;
        fake.errors[request] = -EPERM;
        EXPECT_FALSE(Console::open(std::make_unique<FakeConsole>(fake)));
        EXPECT_TRUE(isRestored(fake)) << request;
    }
}

TEST(Console, IsLeftWhenTheScreenIsGivenUpAndNotBefore) {
    FakeConsole::State fake;
    const auto console = Console::open(std::make_unique<FakeConsole>(fake)).value();
    EXPECT_EQ(console->dispatch(), Console::Event::None);
    raise(SIGRTMIN);
    EXPECT_EQ(console->dispatch(), Console::Event::Leaving);
    EXPECT_TRUE(fake.released.empty());
    EXPECT_TRUE(console->left());
    raise(SIGRTMIN + 1);
    EXPECT_EQ(console->dispatch(), Console::Event::Returned);
    EXPECT_EQ(fake.released, (std::vector<unsigned long>{1, VT_ACKACQ}));
}

} // namespace
} // namespace franken::platform
