// SPDX-License-Identifier: MIT
#include "support/guest.h"

#include <poll.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace franken::test {

namespace fs = std::filesystem;
using platform::SurfaceEvents;
using platform::SurfaceState;

void GuestTest::SetUp() {
    if (std::getenv("GUEST_FOLDER") == nullptr)
        GTEST_SKIP() << "runs in a guest: tests/vm/guest.sh starts it there";
}

void GuestTest::needs(const std::string& file, const std::string& package) {
    if (!fs::exists(file))
        GTEST_SKIP() << "the Debian package " << package << " is not installed";
}

platform::SurfaceOptions GuestTest::options() {
    platform::SurfaceOptions options;
    options.screen.allowSoftware = true;
    return options;
}

std::unique_ptr<platform::Surface> GuestTest::openSurface(const platform::SurfaceOptions& options) {
    Result<std::unique_ptr<platform::Surface>> surface = platform::create(platform::Backend::Kms, options);
    if (!surface) {
        ADD_FAILURE() << toString(surface.error());
        return nullptr;
    }
    return *std::move(surface);
}

SurfaceEvents waitAndDispatch(platform::Surface& surface, std::chrono::milliseconds atMost) {
    pollfd ready = {surface.descriptor(), POLLIN, 0};
    poll(&ready, 1, static_cast<int>(atMost.count()));
    return surface.dispatch();
}

bool waitFor(platform::Surface& surface, SurfaceState state, std::chrono::milliseconds atMost) {
    const auto end = std::chrono::steady_clock::now() + atMost;
    while (surface.state() != state) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
        if (left.count() <= 0)
            return false;
        waitAndDispatch(surface, left);
    }
    return true;
}

platform::CompletedFrame showFrame(platform::Surface& surface, const VmScene& scene) {
    using namespace std::chrono_literals;
    if (!waitFor(surface, SurfaceState::Ready, 5s) || !surface.begin().value()) {
        ADD_FAILURE() << "the surface is " << toString(surface.state()) << ": " << surface.status();
        return {};
    }
    scene.draw(surface.size(), surface.rotation());
    EXPECT_TRUE(surface.submit());
    for (int i = 0; i < 100; ++i)
        if (const SurfaceEvents events = waitAndDispatch(surface, 1s); events.completed)
            return *events.completed;
    ADD_FAILURE() << "the frame was not completed: " << surface.status();
    return {};
}

void plug(const std::string& status) {
    for (const fs::directory_entry& entry : fs::directory_iterator("/sys/class/drm"))
        if (entry.path().filename().string().ends_with("-Virtual-1"))
            writeFile(entry.path() / "status", status);
}

void writeFile(const std::string& path, const std::string& text) {
    std::ofstream file(path);
    file << text << std::flush;
    EXPECT_TRUE(file) << path;
}

std::string readFile(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    std::string read = text.str();
    while (!read.empty() && read.back() == '\n')
        read.pop_back();
    return read;
}

bool isSoak() { return std::getenv("FRANKEN_SOAK") != nullptr; }

int openDescriptors() {
    const fs::directory_iterator all("/proc/self/fd");
    return static_cast<int>(std::distance(begin(all), end(all)));
}

long residentKiB() {
    std::istringstream status(readFile("/proc/self/status"));
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmRSS:"))
            return std::stol(line.substr(6));
    return 0;
}

} // namespace franken::test
