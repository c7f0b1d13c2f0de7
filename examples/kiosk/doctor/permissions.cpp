// SPDX-License-Identifier: MIT
#include "kiosk/doctor/examine.h"

#include <grp.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>

namespace kiosk {

namespace {

using Kind = Finding::Kind;

std::string groupOf(const std::string& file) {
    struct stat status {};
    if (stat(file.c_str(), &status) != 0)
        return {};
    const group* group = getgrgid(status.st_gid);
    return group != nullptr ? group->gr_name : std::to_string(status.st_gid);
}

struct Needed {
    const char* folder;
    const char* prefix;
    const char* purpose;
    const char* group; ///< The owner of such nodes on Raspberry Pi OS.
};

constexpr Needed kNeeded[] = {{"/dev/dri", "card", "the screen", "video"},
                              {"/dev/dri", "renderD", "the GPU", "render"},
                              {"/dev/input", "event", "keys and touch", "input"},
                              {"/dev", "gpiochip", "buttons", "gpio"}};

void examineNodes(const Patient& patient, const Needed& needed, Findings& findings) {
    for (const std::string& name : patient.machine.names(needed.folder)) {
        const std::string node = std::string(needed.folder) + "/" + name;
        const std::string file = patient.machine.path(node).string();
        if (!name.starts_with(needed.prefix) || access(file.c_str(), R_OK | W_OK) == 0)
            continue;
        const std::string group = groupOf(file);
        const bool isPlain = group.empty() || group == "root";
        findings.push_back(
            {Kind::Bad, "permissions", node + " (" + needed.purpose + ") may not be opened by " + userName(),
             isPlain ? std::string("sudo chgrp ") + needed.group + " " + node +
                           "; sudo udevadm trigger brings back what udev's rules say"
                     : "sudo usermod -aG " + group + " " + userName() + ", then log in again"});
        return; // The other nodes of the kind have the same group.
    }
}

} // namespace

std::string userName() {
    const passwd* user = getpwuid(geteuid());
    return user != nullptr ? user->pw_name : std::to_string(geteuid());
}

Findings examinePermissions(const Patient& patient) {
    Findings findings;
    for (const Needed& needed : kNeeded)
        examineNodes(patient, needed, findings);
    if (findings.empty())
        findings.push_back({Kind::Good, "permissions",
                            userName() + " may open what is there of screens, GPUs, inputs and buttons", ""});
    return findings;
}

} // namespace kiosk
