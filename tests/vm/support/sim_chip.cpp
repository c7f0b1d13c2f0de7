// SPDX-License-Identifier: MIT
#include "support/sim_chip.h"

#include "support/guest.h"

#include <unistd.h>

#include <filesystem>

namespace franken::test {

namespace {

const std::string kSim = "/sys/kernel/config/gpio-sim/header";

} // namespace

SimChip::SimChip() {
    std::filesystem::create_directories(kSim + "/bank0");
    writeFile(kSim + "/bank0/num_lines", "28");
    writeFile(kSim + "/bank0/label", "pinctrl-bcm2711");
    writeFile(kSim + "/live", "1");
    m_lines =
        "/sys/devices/platform/" + readFile(kSim + "/dev_name") + "/" + readFile(kSim + "/bank0/chip_name");
}

SimChip::~SimChip() {
    writeFile(kSim + "/live", "0");
    rmdir((kSim + "/bank0").c_str());
    rmdir(kSim.c_str());
}

void SimChip::pull(unsigned line, bool up) const {
    writeFile(file(line, "pull"), up ? "pull-up" : "pull-down");
}

std::string SimChip::value(unsigned line) const { return readFile(file(line, "value")); }

std::string SimChip::file(unsigned line, const char* name) const {
    return m_lines + "/sim_gpio" + std::to_string(line) + "/" + name;
}

} // namespace franken::test
