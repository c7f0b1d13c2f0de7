// SPDX-License-Identifier: MIT
#include "kiosk/report/journal.h"

#include "franken/printable.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>

namespace kiosk {

namespace {

struct Prefix {
    const char *severity, *word;
};

Prefix prefixOf(franken::LogLevel level) {
    if (level == franken::LogLevel::Error)
        return {"<3>", "kiosk: error: "};
    if (level == franken::LogLevel::Warning)
        return {"<4>", "kiosk: warning: "};
    return {"<6>", "kiosk: "};
}

} // namespace

franken::Log journal() {
    const bool isJournal = std::getenv("JOURNAL_STREAM") != nullptr;
    return [isJournal](franken::LogLevel level, std::string_view text) {
        // A line of the journal has one severity: several lines are one message for each. All of them are
        // handed over at once: other threads write, too.
        const std::string prefix = isJournal ? prefixOf(level).severity : prefixOf(level).word;
        const std::string shown = franken::printableLines(text);
        std::string lines;
        for (std::size_t from = 0; from <= shown.size();) {
            const std::size_t end = std::min(shown.find('\n', from), shown.size());
            lines += prefix + shown.substr(from, end - from) + "\n";
            from = end + 1;
        }
        std::cerr << lines << std::flush;
    };
}

} // namespace kiosk
