// SPDX-License-Identifier: MIT
#pragma once

#include "franken/platform/surface.h"
#include "support/scene.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <memory>
#include <string>

namespace franken::test {

/// A test of the guest's screen: skipped outside a guest, so that no real screen is ever touched.
class GuestTest : public testing::Test {
protected:
    void SetUp() override;
    /// Skips the test where that file is not there.
    static void needs(const std::string& file, const std::string& package);

    /// Options that the guest needs: its screen is drawn by the processor.
    static platform::SurfaceOptions options();
    /// A surface on the guest's screen; the test fails where there is none.
    static std::unique_ptr<platform::Surface> openSurface(const platform::SurfaceOptions& options);
};

/// Polls the surface's descriptor for so long at most and dispatches what came.
platform::SurfaceEvents waitAndDispatch(platform::Surface& surface, std::chrono::milliseconds atMost);

/// Dispatches until it is in that state; false where it is not after so long.
bool waitFor(platform::Surface& surface, platform::SurfaceState state, std::chrono::milliseconds atMost);

/// Draws, submits and waits for the completion.
platform::CompletedFrame showFrame(platform::Surface& surface, const VmScene& scene);

/// What the guest's screen shows: the next picture that is scanned out, by vkms' writeback connector. In the
/// format of a fourcc: XR24 or RG16 (5 and 6 bits are widened by repeating the upper ones). `process`: the
/// screen's master.
VmPicture scannedOut(std::uint32_t fourcc, pid_t process = getpid());

/// The descriptor by which a process is the screen's master, as a copy that shares what it may; -1 without.
int screenDescriptor(pid_t process = getpid());

/// Forces the status of the screen's connector: "off", "detect".
void plug(const std::string& status);

/// A file of the guest, such as those of sysfs.
void writeFile(const std::string& path, const std::string& text);
std::string readFile(const std::string& path);

/// Whether there is time for all of it (FRANKEN_SOAK is set): in CI less of the same is run.
bool isSoak();

/// Of this process: descriptors that are open, and resident KiB.
int openDescriptors();
long residentKiB();

} // namespace franken::test
