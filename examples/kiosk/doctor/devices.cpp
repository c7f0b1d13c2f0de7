// SPDX-License-Identifier: MIT
#include "kiosk/control/bindings.h"
#include "kiosk/doctor/examine.h"

#include <algorithm>

namespace kiosk {

namespace {

using Kind = Finding::Kind;

/// Of gpio chips, whose numbers and names move between models.
std::vector<std::string> chipLabels(const Machine& machine) {
    std::vector<std::string> labels;
    for (const std::string& name : machine.names("/sys/class/gpio"))
        if (const auto label = machine.line("/sys/class/gpio/" + name + "/label"))
            labels.push_back(*label);
    for (const std::string& chip : machine.names("/sys/bus/gpio/devices"))
        if (const auto uevent = machine.text("/sys/bus/gpio/devices/" + chip + "/of_node/name"))
            labels.push_back(chip);
    return labels;
}

void examineChips(const Patient& patient, Findings& findings) {
    const std::vector<std::string> nodes = patient.machine.names("/dev");
    const bool hasChip = std::any_of(nodes.begin(), nodes.end(),
                                     [](const std::string& name) { return name.starts_with("gpiochip"); });
    const bool isNeeded = !ActionTable(patient.config).pins().empty() || patient.config.presence.pin >= 0;
    std::string labels;
    for (const std::string& label : chipLabels(patient.machine))
        labels += (labels.empty() ? "" : ", ") + label;
    if (!hasChip)
        findings.push_back(
            {isNeeded ? Kind::Bad : Kind::Note, "buttons", "there is no GPIO chip (/dev/gpiochip0)",
             isNeeded ? "sudo apt full-upgrade && sudo reboot; on other boards: load the driver of the chip"
                      : ""});
    else
        findings.push_back(
            {Kind::Good, "buttons", "GPIO chips: " + (labels.empty() ? std::string("there") : labels), ""});
}

void examineInputs(const Patient& patient, Findings& findings) {
    std::string names;
    for (const std::string& device : patient.machine.names("/sys/class/input"))
        if (device.starts_with("event"))
            if (const auto name = patient.machine.line("/sys/class/input/" + device + "/device/name"))
                names += (names.empty() ? "" : ", ") + *name;
    findings.push_back({Kind::Note, "inputs", names.empty() ? "no keyboard and no touch" : names, ""});
    if (!names.empty() && patient.machine.names("/run/udev").empty())
        findings.push_back({Kind::Bad, "inputs", "udev does not run: keys and touch are not seen",
                            "sudo systemctl start systemd-udevd"});
}

} // namespace

Findings examineDevices(const Patient& patient) {
    Findings findings;
    examineChips(patient, findings);
    examineInputs(patient, findings);
    return findings;
}

} // namespace kiosk
