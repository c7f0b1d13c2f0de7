// SPDX-License-Identifier: MIT
#include "kiosk/report/journal.h"

#include "franken/printable.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>

namespace kiosk {

namespace {

const char* severityOf(franken::LogLevel level) {
    switch (level) {
    case franken::LogLevel::Error:
        return "<3>";
    case franken::LogLevel::Warning:
        return "<4>";
    case franken::LogLevel::Info:
        break;
    }
    return "<6>";
}

const char* wordOf(franken::LogLevel level) {
    switch (level) {
    case franken::LogLevel::Error:
        return "kiosk: error: ";
    case franken::LogLevel::Warning:
        return "kiosk: warning: ";
    case franken::LogLevel::Info:
        break;
    }
    return "kiosk: ";
}

} // namespace

franken::Log journal() {
    const bool isJournal = std::getenv("JOURNAL_STREAM") != nullptr;
    return [isJournal](franken::LogLevel level, std::string_view text) {
        // A line of the journal has one severity: several lines are one message for each.
        const char* prefix = isJournal ? severityOf(level) : wordOf(level);
        const std::string shown = franken::printableLines(text);
        for (std::size_t from = 0; from <= shown.size();) {
            const std::size_t end = std::min(shown.find('\n', from), shown.size());
            std::cerr << prefix << shown.substr(from, end - from) << "\n";
            from = end + 1;
        }
        std::cerr.flush();
    };
}

} // namespace kiosk
