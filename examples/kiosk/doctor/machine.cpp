// SPDX-License-Identifier: MIT
#include "kiosk/doctor/examine.h"

#include <array>
#include <cstdio>
#include <sstream>

namespace kiosk {

namespace {

using Kind = Finding::Kind;

constexpr double kLeastContiguous = 128; // MiB: two models, and the buffers of a 1080p screen.
constexpr double kLeastAvailable = 100;  // MiB: one model while it is loaded.

std::string inMebibytes(const char* form, double value) {
    std::array<char, 160> text{};
    std::snprintf(text.data(), text.size(), form, value);
    return text.data();
}

void examineMemory(const Patient& patient, Findings& findings) {
    const auto total = patient.machine.memoryMebibytes("CmaTotal");
    if (!total || *total <= 0)
        findings.push_back({Kind::Note, "memory", "the kernel sets no contiguous memory (CMA) aside", ""});
    else if (*total < kLeastContiguous)
        findings.push_back(
            {Kind::Bad, "memory",
             inMebibytes("only %.0f MiB of contiguous memory (CMA): models do not fit", *total),
             "in /boot/firmware/config.txt: dtoverlay=vc4-kms-v3d,cma-256, then sudo reboot"});
    else
        findings.push_back(
            {Kind::Good, "memory", inMebibytes("%.0f MiB of contiguous memory (CMA)", *total), ""});
    if (const auto available = patient.machine.memoryMebibytes("MemAvailable");
        available && *available < kLeastAvailable)
        findings.push_back({Kind::Bad, "memory",
                            inMebibytes("only %.0f MiB of memory are available", *available),
                            "end other programs: systemctl list-units --type=service --state=running"});
}

void examineHeat(const Patient& patient, Findings& findings) {
    if (const auto celsius = patient.machine.celsius())
        findings.push_back({*celsius < patient.config.relief.hotCelsius ? Kind::Good : Kind::Bad,
                            "temperature", inMebibytes("the processor has %.0f °C", *celsius),
                            *celsius < patient.config.relief.hotCelsius
                                ? ""
                                : "cool it: a heat sink, a fan, air in the case"});
    const auto bits = patient.machine.throttled();
    if (!bits)
        return findings.push_back(
            {Kind::Note, "throttling", "the firmware does not say whether it throttles", ""});
    if ((*bits & 0x1) != 0)
        findings.push_back({Kind::Bad, "power", "the supply voltage is too low",
                            "use the supply of the Raspberry Pi and a short cable"});
    else if ((*bits & 0x10000) != 0)
        findings.push_back({Kind::Bad, "power", "the supply voltage was too low since the start",
                            "use the supply of the Raspberry Pi and a short cable"});
    if ((*bits & 0xE) != 0)
        findings.push_back({Kind::Bad, "throttling", "the firmware limits the processor's speed",
                            "vcgencmd get_throttled; cool it, or mend its power"});
    else
        findings.push_back({Kind::Good, "throttling", "the processor runs at its full speed", ""});
}

} // namespace

Findings examineMachine(const Patient& patient) {
    Findings findings;
    const std::string model = patient.machine.model();
    findings.push_back({Kind::Note, "machine", model.empty() ? "no Raspberry Pi" : model, ""});
    examineMemory(patient, findings);
    examineHeat(patient, findings);
    return findings;
}

} // namespace kiosk
