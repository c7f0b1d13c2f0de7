// SPDX-License-Identifier: MIT
#include "kiosk/doctor/examine.h"

#include "franken/printable.h"

#include <sys/utsname.h>

namespace kiosk {

namespace {

constexpr const char* kReported[] = {"/proc/cmdline",
                                     "/proc/meminfo",
                                     "/proc/device-tree/model",
                                     "/etc/os-release",
                                     "/proc/sys/kernel/osrelease",
                                     "/boot/firmware/config.txt"};

} // namespace

Findings examineAll(const Patient& patient) {
    Findings all;
    for (const auto examine : {examineMachine, examineSystem, examinePermissions, examineScreens,
                               examineRange, examineRenderer, examineDevices, examineFiles}) {
        const Findings found = examine(patient);
        all.insert(all.end(), found.begin(), found.end());
    }
    return all;
}

std::string reportOf(const Patient& patient, const Findings& findings) {
    std::string report = "# kiosk doctor\n\n" + toText(findings);
    for (const char* file : kReported)
        if (const auto text = patient.machine.text(file))
            report += std::string("\n## ") + file + "\n\n" + franken::printableLines(*text) + "\n";
    return report;
}

} // namespace kiosk
