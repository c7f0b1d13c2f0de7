// SPDX-License-Identifier: MIT
#include "franken/platform/screen.h"

#include "kiosk/doctor/examine.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>

namespace kiosk {

namespace platform = franken::platform;

namespace {

using Kind = Finding::Kind;

const char* wordOf(platform::Connection connection) {
    if (connection == platform::Connection::Unknown)
        return "unknown";
    return connection == platform::Connection::Connected ? "connected" : "not connected";
}

/// The other processes that hold a node of a screen, by /proc; only root sees those of all users.
std::string holdersOf(const Machine& machine, const std::string& node) {
    std::string holders;
    for (const std::string& process : machine.names("/proc")) {
        if (process.find_first_not_of("0123456789") != std::string::npos ||
            process == std::to_string(getpid()))
            continue;
        for (const std::string& descriptor : machine.names("/proc/" + process + "/fd")) {
            std::error_code error;
            const auto target =
                std::filesystem::read_symlink(machine.path("/proc/" + process + "/fd/" + descriptor), error);
            if (error || target != node)
                continue;
            holders += (holders.empty() ? "" : ", ") +
                       machine.line("/proc/" + process + "/comm").value_or("?") + " (" + process + ")";
            break;
        }
    }
    return holders;
}

void examineOutputs(const Patient& patient, const std::vector<platform::ScreenInfo>& screens,
                    Findings& findings) {
    const std::string& wanted = patient.config.screen.output;
    bool isThere = false, isConnected = false;
    std::string node;
    for (const platform::ScreenInfo& screen : screens) {
        findings.push_back({Kind::Note, "screen",
                            screen.output + " of " + screen.driver + " (" + screen.node +
                                "): " + wordOf(screen.connection) +
                                (screen.mode.empty() ? "" : ", prefers " + screen.mode),
                            ""});
        if (!wanted.empty() && screen.output != wanted)
            continue;
        isThere = true;
        isConnected = isConnected || screen.connection == platform::Connection::Connected;
        node = screen.node;
    }
    if (!isThere && !wanted.empty())
        findings.push_back({Kind::Bad, "screen", "there is no output " + wanted,
                            "set screen.output to one of those above, or to \"\""});
    else if (!isConnected && !patient.config.screen.assumeConnected)
        findings.push_back(
            {Kind::Bad, "screen", "no screen is connected",
             "plug it in; where it does not tell, set screen.assume-connected and screen.output"});
    const std::string holders = node.empty() ? std::string() : holdersOf(patient.machine, node);
    if (!holders.empty())
        findings.push_back(
            {Kind::Note, "screen", "held by " + holders + ": only one program can draw on it", ""});
}

} // namespace

Findings examineScreens(const Patient& patient) {
    const auto screens = platform::listScreens(patient.machine.path("/dev/dri").string());
    Findings findings;
    if (screens)
        examineOutputs(patient, *screens, findings);
    else if (screens.error().code == "screen.no-device")
        findings.push_back({Kind::Bad, "screen", "the kernel has no screen (no node in /dev/dri)",
                            "add dtoverlay=vc4-kms-v3d to /boot/firmware/config.txt, then sudo reboot"});
    else
        findings.push_back({Kind::Bad, "screen", screens.error().what, screens.error().remedy});
    return findings;
}

} // namespace kiosk
