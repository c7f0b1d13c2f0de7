// SPDX-License-Identifier: MIT
//
// The life of a screen on a real kernel: schedule, plug and unplug, masters, blanking. In virtual time.
#include "franken/platform/console.h"
#include "support/guest.h"
#include "support/other_master.h"

#include <fcntl.h>
#include <grp.h>
#include <linux/vt.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <xf86drm.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>

namespace franken::test {
namespace {

using namespace std::chrono_literals;
using platform::Blanking;
using platform::CompletedFrame;
using platform::SurfaceState;

class Screen : public GuestTest {
protected:
    void TearDown() override {
        if (!IsSkipped())
            plug("detect");
    }
};

struct Schedule {
    double maxFrameRate;
    int refreshesAFrame;
};

class Pace : public Screen, public testing::WithParamInterface<Schedule> {};
INSTANTIATE_TEST_SUITE_P(Screen, Pace, testing::Values(Schedule{0, 1}, Schedule{30, 2}, Schedule{25, 3}),
                         [](const auto& row) { return "every" + std::to_string(row.param.refreshesAFrame); });

TEST_P(Pace, NoFlipIsMissed) {
    platform::SurfaceOptions options = GuestTest::options();
    options.screen.maxFrameRate = GetParam().maxFrameRate;
    const auto surface = openSurface(options);
    ASSERT_TRUE(surface);
    const VmScene scene(surface->getProcAddress());
    CompletedFrame before = showFrame(*surface, scene);
    before = showFrame(*surface, scene); // The first one set the mode.
    for (int frame = 0; frame < 600; ++frame) {
        const CompletedFrame now = showFrame(*surface, scene);
        ASSERT_EQ(now.sequence - before.sequence, static_cast<unsigned>(GetParam().refreshesAFrame)) << frame;
        ASSERT_EQ(now.missed, 0) << frame;
        before = now;
    }
}

TEST_F(Screen, CountsAFrameThatIsMadeLateAsOneMissed) {
    const auto surface = openSurface(options());
    ASSERT_TRUE(surface);
    const VmScene scene(surface->getProcAddress());
    showFrame(*surface, scene);
    showFrame(*surface, scene);
    ASSERT_TRUE(surface->begin().value());
    scene.draw(surface->size(), surface->rotation());
    usleep(20'000);
    ASSERT_TRUE(surface->submit());
    std::optional<CompletedFrame> late;
    while (!late)
        late = waitAndDispatch(*surface, 1s).completed;
    EXPECT_EQ(late->missed, 1);
    EXPECT_EQ(showFrame(*surface, scene).missed, 0);
}

TEST_F(Screen, IsWaitedForWhereNoneIsThereAtTheStart) {
    plug("off");
    const auto surface = openSurface(options());
    ASSERT_TRUE(surface);
    EXPECT_EQ(surface->state(), SurfaceState::NoScreen);
    EXPECT_FALSE(surface->begin().value());
    EXPECT_FALSE(waitFor(*surface, SurfaceState::Ready, 60s));
    plug("detect");
    ASSERT_TRUE(waitFor(*surface, SurfaceState::Ready, 5s)) << surface->status();
    showFrame(*surface, VmScene(surface->getProcAddress()));
}

TEST_F(Screen, SurvivesUnplugsWithoutEnd) {
    const auto surface = openSurface(options());
    ASSERT_TRUE(surface);
    const VmScene scene(surface->getProcAddress());
    int descriptors = 0;
    long resident = 0;
    constexpr int kCycles = 1000;
    for (int cycle = 0; cycle < kCycles; ++cycle) {
        showFrame(*surface, scene);
        plug("off");
        ASSERT_TRUE(waitFor(*surface, SurfaceState::NoScreen, 5s)) << cycle << ": " << surface->status();
        plug("detect");
        ASSERT_TRUE(waitFor(*surface, SurfaceState::Ready, 5s)) << cycle << ": " << surface->status();
        if (cycle == 100) {
            descriptors = openDescriptors();
            resident = residentKiB();
        }
    }
    EXPECT_EQ(openDescriptors(), descriptors);
    EXPECT_LE(residentKiB(), resident + 256);
}

TEST_F(Screen, AnotherMasterIsNamedAndTheNextStartSucceeds) {
    {
        const OtherMaster other;
        const auto refused = platform::create(platform::Backend::Kms, options());
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().code, "screen.busy");
        EXPECT_NE(refused.error().what.find("vm_screen_test (process "), std::string::npos)
            << refused.error().what;
    }
    EXPECT_TRUE(openSurface(options()));
}

TEST_F(Screen, ComesBackAfterItWasGivenAway) {
    const auto surface = openSurface(options());
    ASSERT_TRUE(surface);
    const VmScene scene(surface->getProcAddress());
    showFrame(*surface, scene);
    surface->pause();
    ASSERT_EQ(surface->state(), SurfaceState::Paused);
    std::optional<OtherMaster> other(std::in_place);
    surface->resume();
    EXPECT_EQ(surface->state(), SurfaceState::Paused) << "the other one still has it";
    EXPECT_FALSE(waitFor(*surface, SurfaceState::Ready, 10s));
    other.reset();
    ASSERT_TRUE(waitFor(*surface, SurfaceState::Ready, 5s)) << surface->status();
    showFrame(*surface, scene);
}

int shownConsole(int console) {
    vt_stat state = {};
    EXPECT_EQ(ioctl(console, VT_GETSTATE, &state), 0);
    return state.v_active;
}

platform::Console::Event nextEvent(platform::Console& console) {
    pollfd ready = {console.descriptor(), POLLIN, 0};
    poll(&ready, 1, 1000);
    return console.dispatch();
}

TEST_F(Screen, IsGivenToAnotherConsoleWhenItIsPausedAndTakenBack) {
    if (!std::filesystem::exists("/dev/vcs1"))
        GTEST_SKIP()
            << "the guest's kernel has no virtual consoles: tests/vm/kernel/build.sh makes one that has";
    const auto console = platform::Console::open("/dev/tty1").value();
    const auto surface = openSurface(options());
    ASSERT_TRUE(surface);
    const VmScene scene(surface->getProcAddress());
    showFrame(*surface, scene);
    const int switcher = open("/dev/tty0", O_RDWR | O_NOCTTY | O_CLOEXEC);
    ASSERT_EQ(ioctl(switcher, VT_ACTIVATE, 2), 0);
    ASSERT_EQ(nextEvent(*console), platform::Console::Event::Leaving);
    surface->pause();
    ASSERT_TRUE(waitFor(*surface, SurfaceState::Paused, 5s)) << surface->status();
    EXPECT_EQ(shownConsole(switcher), 1) << "it was switched before the screen was given up";
    ASSERT_TRUE(console->left());
    ASSERT_EQ(ioctl(switcher, VT_WAITACTIVE, 2), 0);
    EXPECT_EQ(shownConsole(switcher), 2);
    { const OtherMaster onThatConsole; }
    ASSERT_EQ(ioctl(switcher, VT_ACTIVATE, 1), 0);
    ASSERT_EQ(nextEvent(*console), platform::Console::Event::Returned);
    surface->resume();
    EXPECT_EQ(shownConsole(switcher), 1);
    showFrame(*surface, scene);
    close(switcher);
}

TEST_F(Screen, IsBlankedAndWakes) {
    const auto surface = openSurface(options());
    ASSERT_TRUE(surface);
    const VmScene scene(surface->getProcAddress());
    for (const Blanking blanking : {Blanking::Black, Blanking::Off}) {
        showFrame(*surface, scene);
        ASSERT_TRUE(surface->blank(blanking));
        ASSERT_TRUE(waitFor(*surface, SurfaceState::Blanked, 5s)) << surface->status();
        ASSERT_TRUE(surface->blank(Blanking::None));
        showFrame(*surface, scene);
    }
}

TEST_F(Screen, IsWaitedForWhenAnotherMasterStealsIt) {
    const auto surface = openSurface(options());
    ASSERT_TRUE(surface);
    const VmScene scene(surface->getProcAddress());
    showFrame(*surface, scene);
    const int ours = screenDescriptor();
    ASSERT_EQ(drmDropMaster(ours), 0);
    std::optional<OtherMaster> thief(std::in_place);
    ASSERT_TRUE(surface->begin().value());
    ASSERT_TRUE(surface->submit());
    EXPECT_EQ(surface->state(), SurfaceState::Paused) << surface->status();
    EXPECT_FALSE(waitFor(*surface, SurfaceState::Ready, 10s));
    thief.reset();
    ASSERT_TRUE(waitFor(*surface, SurfaceState::Ready, 5s)) << surface->status();
    showFrame(*surface, scene);
    close(ours);
}

TEST_F(Screen, ANodeThatIsNotThereAtBootIsWaitedFor) {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "dri";
    std::filesystem::create_directories(folder);
    platform::SurfaceOptions late = options();
    late.screen.devices = folder;
    const auto surface = openSurface(late);
    ASSERT_TRUE(surface);
    EXPECT_FALSE(surface->hasContext());
    EXPECT_FALSE(waitFor(*surface, SurfaceState::Ready, 60s));
    std::filesystem::create_symlink("/dev/dri/card0", folder / "card3");
    bool announced = false;
    for (int turn = 0; turn < 50 && !announced; ++turn)
        announced = waitAndDispatch(*surface, 100ms).contextReplaced;
    EXPECT_TRUE(announced);
    ASSERT_EQ(surface->state(), SurfaceState::Ready) << surface->status();
    showFrame(*surface, VmScene(surface->getProcAddress()));
}

/// What a process holds must not grow with the turns of its loop.
void expectNothingGrows(int turns, long kiB, const std::function<void()>& turn) {
    for (int warm = 0; warm < 100; ++warm)
        turn();
    const int descriptors = openDescriptors();
    const long resident = residentKiB();
    for (int i = 0; i < turns; ++i)
        turn();
    EXPECT_EQ(openDescriptors(), descriptors);
    EXPECT_LE(residentKiB(), resident + kiB);
    std::cout << turns << " turns, " << residentKiB() - resident << " KiB more" << std::endl;
}

TEST_F(Screen, NothingGrowsWhileNothingIsDrawn) {
    const auto surface = openSurface(options());
    ASSERT_TRUE(surface);
    const int turns = isSoak() ? 1'000'000 : 10'000;
    const auto turn = [&] { surface->dispatch(); };
    plug("off");
    ASSERT_TRUE(waitFor(*surface, SurfaceState::NoScreen, 5s));
    expectNothingGrows(turns, 64, turn);
    plug("detect");
    ASSERT_TRUE(waitFor(*surface, SurfaceState::Ready, 5s));
    ASSERT_TRUE(surface->blank(Blanking::Off));
    ASSERT_TRUE(waitFor(*surface, SurfaceState::Blanked, 5s));
    expectNothingGrows(turns, 64, turn);
    surface->pause();
    ASSERT_EQ(surface->state(), SurfaceState::Paused);
    expectNothingGrows(turns, 64, turn);
}

TEST_F(Screen, NothingGrowsWhileFramesAreDrawn) {
    const auto surface = openSurface(options());
    ASSERT_TRUE(surface);
    const VmScene scene(surface->getProcAddress());
    expectNothingGrows(isSoak() ? 20'000 : 500, 256, [&] { showFrame(*surface, scene); });
}

TEST_F(Screen, MissingRightsAreToldWithTheGroups) {
    const std::string said = std::filesystem::temp_directory_path() / "rights";
    writeFile(said, "");
    std::filesystem::permissions(said, std::filesystem::perms::all);
    const pid_t nobody = fork();
    if (nobody == 0) {
        constexpr uid_t kNobody = 65534;
        const bool is = setgroups(0, nullptr) == 0 && setuid(kNobody) == 0;
        const auto refused = platform::create(platform::Backend::Kms, options());
        std::ofstream(said) << (is && !refused ? toString(refused.error()) : "it was not refused");
        _exit(0);
    }
    waitpid(nobody, nullptr, 0);
    EXPECT_NE(readFile(said).find("groups video and render) [screen.permission]"), std::string::npos)
        << readFile(said);
}

TEST_F(Screen, SoftwareIsRefusedUnlessItIsAllowed) {
    const auto refused = platform::create(platform::Backend::Kms, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, "surface.software");
    EXPECT_TRUE(openSurface(options())) << "something was left acquired";
}

} // namespace
} // namespace franken::test
