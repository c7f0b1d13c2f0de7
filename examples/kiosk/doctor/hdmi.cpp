// SPDX-License-Identifier: MIT
// What screens on HDMI make of the range of codes, by their EDID (VESA E-EDID 1.4; CTA-861 for its
// extension).
#include "kiosk/doctor/examine.h"

namespace kiosk {

namespace {

using Kind = Finding::Kind;

constexpr std::size_t kBlock = 128;  // Bytes.
constexpr unsigned char kCta = 0x02; // The tag of CTA-861's extension block.
constexpr unsigned kBasicAudio = 0x40;

/// What the screen can do besides pictures, by CTA-861; nothing for one of DVI, to which the kernel sends
/// all codes by itself.
std::optional<unsigned> abilitiesOf(const std::string& edid) {
    std::optional<unsigned> abilities;
    for (std::size_t block = kBlock; block + kBlock <= edid.size(); block += kBlock)
        if (static_cast<unsigned char>(edid[block]) == kCta)
            abilities = abilities.value_or(0) | static_cast<unsigned char>(edid[block + 3]);
    return abilities;
}

Finding findingOf(const std::string& output, std::optional<unsigned> abilities, const std::string& range) {
    // Television sets take sound, and monitors without loudspeakers do not.
    if ((abilities.value_or(0) & kBasicAudio) != 0)
        return {Kind::Note, "range",
                output +
                    " takes sound, as television sets do: where dark parts of the picture are lost or grey, "
                    "try another screen.range than \"" +
                    range + "\"",
                ""};
    if (range == "full" || (range == "automatic" && !abilities))
        return {Kind::Good, "range", output + " takes no sound, and gets all codes, as monitors want them",
                ""};
    return {Kind::Bad, "range",
            output + " takes no sound, so it is a monitor, which shows black as grey where codes are limited",
            "set screen.range = \"full\""};
}

} // namespace

Findings examineRange(const Patient& patient) {
    Findings findings;
    const std::string folder = "/sys/class/drm/";
    for (const std::string& name : patient.machine.names("/sys/class/drm")) {
        const std::size_t output = name.find("HDMI-");
        if (output == std::string::npos || patient.machine.line(folder + name + "/status") != "connected")
            continue;
        const std::optional<std::string> edid = patient.machine.text(folder + name + "/edid");
        if (edid && edid->size() >= kBlock)
            findings.push_back(
                findingOf(name.substr(output), abilitiesOf(*edid), patient.config.screen.range));
    }
    return findings;
}

} // namespace kiosk
