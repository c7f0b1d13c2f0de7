// SPDX-License-Identifier: MIT
#include "franken/platform/backlight.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <vector>

namespace franken::platform {

namespace fs = std::filesystem;

namespace {

int readNumber(const fs::path& file) {
    int number = -1;
    std::ifstream(file) >> number;
    return number;
}

} // namespace

Result<Backlight> Backlight::find(const std::string& name, const std::string& folder) {
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
        names.push_back(at->path().filename());
    std::sort(names.begin(), names.end());
    for (const std::string& found : names) {
        const std::string device = folder + "/" + found;
        const int most = readNumber(fs::path(device) / "max_brightness");
        if ((name.empty() || name == found) && most > 0)
            return Backlight(found, device, most);
    }
    return Error{"backlight.missing", name.empty() ? folder : name, "there is no such backlight",
                 "only panels have one; blank HDMI screens by DPMS or CEC"};
}

Result<void> Backlight::setBrightness(double brightness) {
    if (!(brightness >= 0 && brightness <= 1))
        return Error{"backlight.range", m_name, "the brightness must be between 0 and 1", ""};
    std::ofstream file(m_folder + "/brightness");
    file << std::lround(brightness * m_most) << '\n' << std::flush;
    if (!file)
        return Error{"backlight.write", m_folder + "/brightness", "it cannot be written",
                     "give the group video write permission by a udev rule"};
    return {};
}

Result<double> Backlight::brightness() const {
    const int now = readNumber(fs::path(m_folder) / "brightness");
    if (now < 0)
        return Error{"backlight.missing", m_folder, "it is gone", ""};
    return static_cast<double>(now) / m_most;
}

} // namespace franken::platform
