// SPDX-License-Identifier: MIT
#pragma once

#include "support/child.h"
#include "support/guest.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace franken::test {

/// The kiosk as a process of its own, on the guest's screen, with a folder of its own for all that it reads
/// and writes. Its /sys, /proc and /run are files below root(), which tests write.
class KioskInGuest : public GuestTest {
protected:
    void SetUp() override;
    void TearDown() override;

    /// Starts it with a configuration: that of all tests, which ends in [files], and these lines of TOML.
    void start(const std::string& config, const std::string& program = KIOSK);
    void writeConfig(const std::string& config) const;
    Child& kiosk() { return *m_kiosk; }

    /// All that it has logged.
    std::string log() const;
    /// Waits for a line that has this in it, in what comes after the last one that was waited for.
    testing::AssertionResult logs(const std::string& text, int seconds = 10);

    /// What the screen shows, in a moment; only while the picture moves: the screen's copies wait for a
    /// frame.
    VmPicture scanned(const std::string& name) const;
    /// What was drawn, by a screenshot.
    VmPicture picture(const std::string& name) const;
    /// The statistics, newly written.
    std::string metrics() const;
    /// A number of them; a failure where they lack it.
    static double valueOf(const std::string& name, const std::string& metrics);
    double metric(const std::string& name) const { return valueOf(name, metrics()); }
    /// Copies one of Debian's models to the watched folder.
    void copyModel(const std::string& model, const std::string& as) const;

    std::filesystem::path folder() const { return m_folder; }
    std::filesystem::path models() const { return m_folder / "models"; }
    /// A file of the machine, as "/sys/class/thermal/thermal_zone0/temp".
    void writeMachine(const std::string& file, const std::string& text) const;

private:
    std::filesystem::path m_folder;
    std::unique_ptr<Child> m_kiosk;
    std::size_t m_read = 0; ///< Of the log.
};

/// The share of pixels that are not all but black.
double brightShare(const VmPicture& picture);

inline const std::string kModels = "/usr/share/assimp/models/glTF2/";
inline const std::string kBox = kModels + "BoxTextured-glTF-Binary/BoxTextured.glb";
inline const std::string kEngine = kModels + "2CylinderEngine-glTF-Binary/2CylinderEngine.glb";

} // namespace franken::test
