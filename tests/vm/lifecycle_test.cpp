// SPDX-License-Identifier: MIT
//
// Whatever happens to a program, and at whichever point of its life: it is noticed in time, and the next
// start succeeds at once. In virtual time.
#include "franken/platform/console.h"
#include "franken/platform/gpio.h"
#include "support/child.h"
#include "support/faults.h"
#include "support/guest.h"
#include "support/service_manager.h"
#include "support/sim_chip.h"

#include <drm_fourcc.h>
#include <fcntl.h>
#include <linux/kd.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <xf86drm.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <thread>

namespace franken::test {
namespace {

using namespace std::chrono_literals;
using platform::SurfaceState;
using Clock = std::chrono::steady_clock;

std::vector<Call> allCalls() {
    std::vector<Call> calls;
    for (int call = 0; call < kCalls; ++call)
        calls.push_back(static_cast<Call>(call));
    return calls;
}

std::string callName(const testing::TestParamInfo<Call>& info) { return toString(info.param); }

class Life : public GuestTest {
protected:
    void TearDown() override { onCall = {}; }

    /// Nobody is the screen's master; a start is ready at once, and shows a frame.
    static void expectASuccessfulStart() {
        const int another = open("/dev/dri/card0", O_RDWR | O_CLOEXEC);
        EXPECT_EQ(drmSetMaster(another), 0) << "somebody is the screen's master still";
        close(another);
        const auto surface = openSurface(options());
        ASSERT_TRUE(surface);
        ASSERT_EQ(surface->state(), SurfaceState::Ready) << surface->status();
        showFrame(*surface, VmScene(surface->getProcAddress()));
    }
};

class StartUp : public Life, public testing::WithParamInterface<Call> {
public:
    static void SetUpTestSuite() {
        if (std::getenv("GUEST_FOLDER") != nullptr)
            expectASuccessfulStart(); // What Mesa keeps for the process is there then.
    }
};
INSTANTIATE_TEST_SUITE_P(Life, StartUp, testing::ValuesIn(allCalls()), callName);

/// Tries to draw for a while; whether a frame was shown.
bool showsAFrame(platform::Surface& surface) {
    for (int turn = 0; turn < 8; ++turn) {
        if (const Result<bool> begun = surface.begin(); begun && *begun && !surface.submit())
            return false;
        if (waitAndDispatch(surface, 500ms).completed)
            return true;
    }
    return false;
}

TEST_P(StartUp, AnErrorLeavesNothingAcquired) {
    const int descriptors = openDescriptors();
    for (const bool once : {false, true}) {
        bool failed = false;
        onCall = [&](Call call) {
            const bool fails = call == GetParam() && !(once && failed);
            failed = failed || fails;
            return fails ? -EIO : kPass;
        };
        const auto surface = platform::create(platform::Backend::Kms, options());
        const bool shows = surface && showsAFrame(**surface);
        EXPECT_TRUE(failed) << "the call is not made";
        EXPECT_TRUE(once || !shows) << "its error is not seen";
        EXPECT_TRUE(surface || !surface.error().remedy.empty()) << toString(surface.error());
        onCall = {};
    }
    EXPECT_EQ(openDescriptors(), descriptors);
    expectASuccessfulStart();
}

/// The kiosk that is harmed, and what it needs.
class Harmed : public Life {
protected:
    void SetUp() override {
        Life::SetUp();
        if (!IsSkipped())
            m_chip.emplace();
    }
    static std::vector<std::string> kiosk(const std::vector<std::string>& harm) {
        std::vector<std::string> command = {FRANKEN_HARMED_KIOSK};
        command.insert(command.end(), harm.begin(), harm.end());
        return command;
    }
    /// Screen, button and console can be had.
    static void expectThatAllIsFree() {
        expectASuccessfulStart();
        EXPECT_TRUE(platform::GpioInputs({{.name = "next", .pin = {.number = 17}}}, {}, Log()).complete());
        if (std::filesystem::exists("/dev/vcs1")) {
            EXPECT_TRUE(platform::Console::open("/dev/tty1"));
            EXPECT_EQ(keyboardMode(), K_UNICODE) << "the console reads no keys any more";
        }
    }
    static int keyboardMode() {
        int mode = -1;
        const int console = open("/dev/tty1", O_RDWR | O_NOCTTY);
        ioctl(console, KDGKBMODE, &mode);
        close(console);
        return mode;
    }

private:
    std::optional<SimChip> m_chip;
};

class Ended : public Harmed, public testing::WithParamInterface<Call> {};
/// A process costs a second in a user-mode kernel: all calls only where there is time.
INSTANTIATE_TEST_SUITE_P(
    Life, Ended,
    testing::ValuesIn(isSoak() ? allCalls() : std::vector{Call::Initialize, Call::TestCommit, Call::Commit}),
    callName);

TEST_P(Ended, BySigkillLeavesNothingAcquired) {
    EXPECT_EQ(Child(kiosk({"kill", toString(GetParam())})).wait(), 128 + SIGKILL);
    expectThatAllIsFree();
}

TEST_P(Ended, BySigtermLeavesNothingAcquired) {
    EXPECT_EQ(Child(kiosk({"term", toString(GetParam())})).wait(), 0);
    expectThatAllIsFree();
}

TEST_F(Harmed, SigtermInTheMiddleOfTheLoopEndsItInOrder) {
    Child running(kiosk({}));
    std::this_thread::sleep_for(1s);
    EXPECT_TRUE(running.runs());
    EXPECT_EQ(Child(kiosk({})).wait(), 4) << "a second one is told that the screen is taken";
    running.signal(SIGTERM);
    EXPECT_EQ(running.wait(), 0);
    expectThatAllIsFree();
}

constexpr auto kWatchdog = 2s;

/// Reads until the watchdog has not been heard of for its time; how long that took.
std::chrono::milliseconds silentAfter(const FakeServiceManager& manager) {
    const auto start = Clock::now();
    for (auto last = start; Clock::now() - last < kWatchdog;) {
        pollfd ready = {manager.descriptor(), POLLIN, 0};
        poll(&ready, 1, static_cast<int>((last + kWatchdog - Clock::now()) / 1ms) + 1);
        if (manager.next() == "WATCHDOG=1")
            last = Clock::now();
    }
    return std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - start);
}

TEST_F(Harmed, AFrozenLoopIsSilentAndTheManagerEndsIt) {
    const FakeServiceManager manager(kWatchdog);
    Child frozen(kiosk({"freeze"}));
    const std::chrono::milliseconds silent = silentAfter(manager);
    EXPECT_GE(silent, 2500ms) << "it was silent before it froze";
    EXPECT_LE(silent, 3500ms);
    EXPECT_TRUE(frozen.runs());
    frozen.signal(SIGABRT); // As systemd does.
    EXPECT_EQ(frozen.wait(), 128 + SIGABRT);
    expectThatAllIsFree();
}

TEST_F(Harmed, ARunningLoopIsNeverSilent) {
    const FakeServiceManager manager(kWatchdog);
    Child running(kiosk({}));
    std::jthread end([&] {
        std::this_thread::sleep_for(6s);
        running.signal(SIGTERM);
    });
    EXPECT_GE(silentAfter(manager), 7s);
}

struct Ladder {
    const char* harm;
    std::chrono::seconds atMost;
    const char* lastWords;
};

TEST_F(Harmed, FaultsOfTheGpuEndInTheProcessExit) {
    const Ladder ladders[] = {{"lose", 11s, "the driver does not answer page flips"},
                              {"canary", 2s, "the GPU does not draw what it is told to"}};
    for (const auto& [harm, atMost, lastWords] : ladders) {
        SCOPED_TRACE(harm);
        const std::string output = std::filesystem::temp_directory_path() / harm;
        const auto start = Clock::now();
        EXPECT_EQ(Child(kiosk({harm}), output).wait(), 1);
        EXPECT_LE(Clock::now() - start, atMost);
        EXPECT_NE(readFile(output).find(lastWords), std::string::npos) << readFile(output);
        expectThatAllIsFree();
    }
}

struct Injected {
    int error;
    SurfaceState state;
    bool newContext;
};

class CommitError : public Life, public testing::WithParamInterface<Injected> {};
INSTANTIATE_TEST_SUITE_P(Life, CommitError,
                         testing::Values(Injected{EBUSY, SurfaceState::Recovering, false},
                                         Injected{ENOSPC, SurfaceState::Recovering, false},
                                         Injected{ENOMEM, SurfaceState::Recovering, false},
                                         Injected{EINVAL, SurfaceState::Ready, false},
                                         Injected{EACCES, SurfaceState::Paused, false},
                                         Injected{ENODEV, SurfaceState::NoScreen, true}),
                         [](const auto& row) { return std::string(strerrorname_np(row.param.error)); });

TEST_P(CommitError, IsOutlived) {
    const auto surface = openSurface(options());
    ASSERT_TRUE(surface);
    std::optional<VmScene> scene(std::in_place, surface->getProcAddress());
    const VmPicture before = (showFrame(*surface, *scene), scannedOut(DRM_FORMAT_XRGB8888));
    onCall = [](Call call) { return call == Call::Commit ? -GetParam().error : kPass; };
    ASSERT_TRUE(surface->begin().value());
    scene->draw(surface->size(), surface->rotation());
    ASSERT_TRUE(surface->submit());
    EXPECT_EQ(surface->state(), GetParam().state) << surface->status();
    onCall = {};
    bool newContext = false, shown = false;
    for (const auto end = Clock::now() + 5s; !shown && Clock::now() < end;) {
        const platform::SurfaceEvents events = waitAndDispatch(*surface, 100ms);
        newContext = newContext || events.contextReplaced;
        if (events.contextReplaced)
            scene.emplace(surface->getProcAddress());
        shown = events.completed.has_value() || surface->state() == SurfaceState::Ready;
    }
    EXPECT_TRUE(shown) << surface->status();
    EXPECT_EQ(newContext, GetParam().newContext);
    showFrame(*surface, *scene);
    const VmPicture after = scannedOut(DRM_FORMAT_XRGB8888);
    EXPECT_EQ(after == before, GetParam().error != EINVAL)
        << "another mode is taken after EINVAL, and no other";
}

} // namespace
} // namespace franken::test
