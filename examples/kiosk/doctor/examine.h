// SPDX-License-Identifier: MIT
#pragma once

#include "franken/platform/surface.h"
#include "kiosk/config/config.h"
#include "kiosk/doctor/finding.h"
#include "kiosk/machine/machine.h"

#include <string>
#include <vector>

/// The examinations of `kiosk doctor`. What they read of /sys, /proc, /dev and /run lies below the machine's
/// root, so that tests can show them any machine.
namespace kiosk {

struct Patient {
    Machine machine;
    Config config;
    bool isReal = true; ///< The root is /: devices may be opened.
};

Findings examineMachine(const Patient& patient);     ///< Model, memory, heat, throttling.
Findings examineSystem(const Patient& patient);      ///< Clock, console, watchdog, services.
Findings examinePermissions(const Patient& patient); ///< Nodes and groups.
Findings examineScreens(const Patient& patient);     ///< Nodes, connectors, modes, who is master.
Findings examineRange(const Patient& patient);       ///< Range of codes, for what is plugged into HDMI.
Findings examineRenderer(const Patient& patient);    ///< The driver and its limits; opens a context.
Findings examineDevices(const Patient& patient);     ///< GPIO chips and inputs.
Findings examineFiles(const Patient& patient);       ///< The configuration's folders and files.

/// Who runs the examination, and so whom its commands give rights to.
std::string userName();

/// All of them.
Findings examineAll(const Patient& patient);

/// What a person can send: the findings, and the files that they come from.
std::string reportOf(const Patient& patient, const Findings& findings);

} // namespace kiosk
