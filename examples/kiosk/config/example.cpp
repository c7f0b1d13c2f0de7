// SPDX-License-Identifier: MIT
#include "kiosk/config/example.h"

#include "kiosk/config/setting.h"

#include <sstream>

namespace kiosk {

namespace {

constexpr std::size_t kWidth = 100;

/// In lines that begin with "# ".
std::string comment(const std::string& text) {
    std::istringstream words(text);
    std::string out, line = "#";
    for (std::string word; words >> word;) {
        if (line.size() + 1 + word.size() > kWidth) {
            out += line + "\n";
            line = "#";
        }
        line += " " + word;
    }
    return line == "#" ? out : out + line + "\n";
}

} // namespace

std::string exampleConfig() {
    const Config defaults;
    std::string out =
        comment("All settings of the kiosk, with their defaults. Colours have three numbers. `kiosk check "
                "FILE` says what is wrong with a file. The kiosk sees when its file changes; what is "
                "marked \"after a restart\" waits for one. Each is an option, too: --screen.mode "
                "1280x720.");
    std::string section;
    for (const Setting& setting : settings()) {
        if (sectionOf(setting) != section) {
            section = sectionOf(setting);
            out += "\n[" + section + "]\n" + comment(sectionHelp(section));
        }
        out += comment(setting.help);
        if (!setting.help.empty())
            out += "# (" + typeOf(setting) + (setting.takes == Takes::Restart ? "; after a restart" : "") +
                   ")\n";
        out += nameOf(setting) + " = " + valueText(setting, defaults) + "\n";
    }
    return out;
}

} // namespace kiosk
