// SPDX-License-Identifier: MIT
#include "kiosk/vm_kiosk.h"

#include "franken/file.h"
#include "franken/image.h"
#include "support/shell.h"

#include <drm_fourcc.h>

#include <algorithm>
#include <csignal>
#include <iostream>
#include <thread>

namespace franken::test {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

void KioskInGuest::SetUp() {
    GuestTest::SetUp();
    needs(kModels, "assimp-testmodels");
    const testing::TestInfo& info = *testing::UnitTest::GetInstance()->current_test_info();
    m_folder = fs::path("/run/kiosk") / info.name();
    fs::create_directories(models());
    fs::create_directories(m_folder / "root");
}

void KioskInGuest::TearDown() {
    m_kiosk.reset();
    if (HasFailure())
        std::cerr << log();
    if (!IsSkipped())
        plug("detect");
}

void KioskInGuest::writeConfig(const std::string& config) const {
    std::ofstream(m_folder / "part.toml") << "[screen]\nallow-software = true\nmax-frame-rate = 20\n"
                                             "[files]\nstate = \"state\"\nmetrics = \"kiosk.prom\"\n"
                                          << config;
    fs::rename(m_folder / "part.toml", m_folder / "kiosk.toml");
}

void KioskInGuest::start(const std::string& config, const std::string& program) {
    writeConfig(config);
    m_read = log().size();
    m_kiosk = std::make_unique<Child>(std::vector<std::string>{program, "--config",
                                                               (m_folder / "kiosk.toml").string(), "--root",
                                                               (m_folder / "root").string()},
                                      (m_folder / "log").string());
}

std::string KioskInGuest::log() const { return readText(m_folder / "log"); }

testing::AssertionResult KioskInGuest::logs(const std::string& text, int seconds) {
    for (int tries = 0; tries <= seconds * 10; ++tries) {
        const std::string all = log();
        if (const std::size_t at = all.find(text, m_read); at != std::string::npos) {
            m_read = at + text.size();
            return testing::AssertionSuccess();
        }
        std::this_thread::sleep_for(100ms);
    }
    return testing::AssertionFailure() << "\"" << text << "\" was not logged within " << seconds << " s";
}

VmPicture KioskInGuest::scanned(const std::string& name) const {
    VmPicture shown = scannedOut(DRM_FORMAT_XRGB8888, m_kiosk->process());
    writePpm(shown, name);
    return shown;
}

VmPicture KioskInGuest::picture(const std::string& name) const {
    const std::size_t before = log().size();
    m_kiosk->signal(SIGUSR1);
    for (int tries = 0; tries < 100 && log().find("screenshot: ", before) == std::string::npos; ++tries)
        std::this_thread::sleep_for(20ms);
    const auto file = franken::readFile(m_folder / "state/screenshot.png", 1 << 20);
    const auto image = file ? decodeImage(*file) : Result<Image>(file.error());
    EXPECT_TRUE(image) << toString(image.error());
    if (!image)
        return {};
    VmPicture shown{{image->width, image->height}, {}};
    for (std::size_t at = 0; at < image->rgba.size(); at += 4)
        shown.pixels.push_back(static_cast<std::uint32_t>(image->rgba[at] << 16 | image->rgba[at + 1] << 8 |
                                                          image->rgba[at + 2]));
    writePpm(shown, name);
    return shown;
}

std::string KioskInGuest::metrics() const {
    const fs::path file = m_folder / "kiosk.prom";
    fs::remove(file);
    for (int tries = 0; tries < 2000 && !fs::exists(file); ++tries)
        std::this_thread::sleep_for(10ms);
    return readText(file);
}

double KioskInGuest::valueOf(const std::string& name, const std::string& metrics) {
    const std::string line = "\nfrankenshader_kiosk_" + name + " ";
    const std::size_t at = metrics.find(line);
    EXPECT_NE(at, std::string::npos) << name << " in\n" << metrics;
    return at == std::string::npos ? -1 : std::stod(metrics.substr(at + line.size()));
}

void KioskInGuest::copyModel(const std::string& model, const std::string& as) const {
    fs::copy_file(model, models() / as, fs::copy_options::overwrite_existing);
}

void KioskInGuest::writeMachine(const std::string& file, const std::string& text) const {
    const fs::path path = m_folder / "root" / file.substr(1);
    fs::create_directories(path.parent_path());
    std::ofstream(path) << text;
}

double brightShare(const VmPicture& picture) {
    const auto isBright = [](std::uint32_t pixel) {
        return (pixel & 0xFF) > 24 || (pixel >> 8 & 0xFF) > 24 || (pixel >> 16 & 0xFF) > 24;
    };
    const auto bright = std::count_if(picture.pixels.begin(), picture.pixels.end(), isBright);
    return static_cast<double>(bright) / static_cast<double>(picture.pixels.size());
}

} // namespace franken::test
