// SPDX-License-Identifier: MIT
#include "kiosk/decide/timetable.h"
#include "kiosk/doctor/examine.h"

#include <algorithm>
#include <sstream>

namespace kiosk {

namespace {

using Kind = Finding::Kind;

/// The words of the kernel's command line.
std::vector<std::string> kernelWords(const Machine& machine) {
    std::istringstream line(machine.line("/proc/cmdline").value_or(""));
    std::vector<std::string> words;
    for (std::string word; line >> word;)
        words.push_back(word);
    return words;
}

void examineConsole(const Patient& patient, Findings& findings) {
    const auto blank = patient.machine.line("/sys/module/kernel/parameters/consoleblank");
    if (blank && *blank != "0")
        findings.push_back({Kind::Bad, "console",
                            "the kernel switches the screen off after " + *blank + " s (consoleblank)",
                            "add consoleblank=0 to /boot/firmware/cmdline.txt, then sudo reboot"});
    else
        findings.push_back({Kind::Good, "console", "the kernel does not blank the screen", ""});
    const std::vector<std::string> words = kernelWords(patient.machine);
    if (std::find(words.begin(), words.end(), "nomodeset") != words.end())
        findings.push_back({Kind::Bad, "console", "the kernel was told not to drive the screen (nomodeset)",
                            "take nomodeset from /boot/firmware/cmdline.txt, then sudo reboot"});
}

void examineWatchdog(const Patient& patient, Findings& findings) {
    const std::vector<std::string> watchdogs = patient.machine.names("/sys/class/watchdog");
    if (watchdogs.empty())
        return findings.push_back({Kind::Bad, "watchdog",
                                   "there is no hardware watchdog: a frozen kernel stays frozen",
                                   "add dtparam=watchdog=on to /boot/firmware/config.txt, then sudo reboot"});
    const std::string folder = "/sys/class/watchdog/" + watchdogs.front();
    const bool isUsed = patient.machine.line(folder + "/state").value_or("") == "active";
    findings.push_back({isUsed ? Kind::Good : Kind::Bad, "watchdog",
                        isUsed ? "the hardware watchdog is in use" : "nobody uses the hardware watchdog",
                        isUsed ? ""
                               : "sudo install -D -m 644 watchdog.conf "
                                 "/etc/systemd/system.conf.d/watchdog.conf && sudo systemctl daemon-reexec"});
}

void examineClock(const Patient& patient, Findings& findings) {
    const bool isSynchronised = isClockSynchronised(patient.isReal ? "" : patient.machine.path("/").string());
    const auto& hours = patient.config.hours;
    const bool isNeeded =
        std::any_of(hours.begin(), hours.end(), [](const Texts& day) { return !day.empty(); });
    if (isSynchronised)
        findings.push_back({Kind::Good, "clock", "the clock is synchronised", ""});
    else
        findings.push_back({isNeeded ? Kind::Bad : Kind::Note, "clock",
                            "the clock is not synchronised: opening hours are not heeded",
                            "sudo timedatectl set-ntp true"});
}

void examineSession(const Patient& patient, Findings& findings) {
    for (const char* unit : {"lightdm", "gdm", "sddm"})
        if (patient.machine.line("/etc/systemd/system/display-manager.service") &&
            patient.machine.text("/etc/systemd/system/display-manager.service")->find(unit) !=
                std::string::npos)
            findings.push_back({Kind::Bad, "desktop",
                                std::string("a desktop (") + unit + ") takes the screen at start",
                                "sudo systemctl set-default multi-user.target && sudo reboot"});
}

} // namespace

Findings examineSystem(const Patient& patient) {
    Findings findings;
    examineConsole(patient, findings);
    examineWatchdog(patient, findings);
    examineClock(patient, findings);
    examineSession(patient, findings);
    return findings;
}

} // namespace kiosk
