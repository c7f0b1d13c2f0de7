// SPDX-License-Identifier: MIT
// The handbook's first program, in a window: the model is seen, and turns.
#include "support/shell.h"
#include "x_server.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <thread>

namespace franken::test {
namespace {

using namespace std::chrono_literals;

class First : public testing::Test {
protected:
    void SetUp() override {
        setenv("GALLIUM_DRIVER", "softpipe", 0);
        setenv("LIBGL_ALWAYS_SOFTWARE", "1", 0);
        setenv("SDL_VIDEODRIVER", "x11", 1);
    }

    /// The server's picture: 640 x 480 pixels of four bytes at the end of an X window dump.
    std::string pixels() const {
        constexpr std::size_t kBytes = std::size_t{4} * 640 * 480;
        const std::string file = readText(m_folder / "Xvfb_screen0");
        return file.size() < kBytes ? "" : file.substr(file.size() - kBytes);
    }

    /// A picture in which at least that many pixels differ from the one before; empty after half a minute.
    std::string pictureUnlike(const std::string& before, std::size_t least) const {
        for (const auto end = std::chrono::steady_clock::now() + 30s;
             std::chrono::steady_clock::now() < end;) {
            std::string now = pixels();
            std::size_t count = 0;
            for (std::size_t i = 0; i + 4 <= now.size() && now.size() == before.size(); i += 4)
                count += std::memcmp(&now[i], &before[i], 3) != 0;
            if (count >= least)
                return now;
            std::this_thread::sleep_for(50ms);
        }
        return "";
    }

    const std::filesystem::path m_folder = emptyTestFolder();
};

TEST_F(First, ShowsAModelThatTurnsInAWindow) {
    if (runIn(m_folder, "command -v Xvfb").code != 0)
        GTEST_SKIP() << "needs an X server (Debian package xvfb)";
    const XServer server(m_folder.string());
    ASSERT_FALSE(server.display().empty());
    const std::string empty = pixels();
    ASSERT_FALSE(empty.empty()) << "the server has no picture";
    const Outcome started = runIn(m_folder, "export DISPLAY=" + server.display() +
                                                "; " FIRST " " URN_GLB " >log 2>&1 & echo $! >process");
    ASSERT_EQ(started.code, 0);
    const std::string shown = pictureUnlike(empty, 10'000);
    EXPECT_FALSE(shown.empty()) << "the window shows no model: " << readText(m_folder / "log");
    EXPECT_FALSE(pictureUnlike(shown, 500).empty()) << "it does not turn";
    runIn(m_folder, "kill $(cat process)");
    EXPECT_EQ(readText(m_folder / "log"), "");
}

TEST_F(First, SaysWhatItCannotShow) {
    const Outcome outcome = runIn(m_folder, "DISPLAY= WAYLAND_DISPLAY= " FIRST " " URN_GLB);
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("start it on a desktop"), std::string::npos) << outcome.err;
}

} // namespace
} // namespace franken::test
