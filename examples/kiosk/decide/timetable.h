// SPDX-License-Identifier: MIT
#pragma once

#include "kiosk/config/config.h"

#include <ctime>
#include <optional>

namespace kiosk {

/// Whether the shop is open. Pure: the caller passes the local time.
class Timetable {
public:
    Timetable() = default;
    explicit Timetable(const Config& config);

    /// Without any opening hours, always.
    bool isOpen(const std::tm& local) const;
    /// Seconds until isOpen() may change: at most a minute, so that changes of the time zone are not missed.
    int secondsToLook(const std::tm& local) const;
    /// Whether the daily restart is due in this minute.
    bool isRestartDue(const std::tm& local) const;

private:
    struct Span {
        int from, to; ///< Minutes after midnight.
    };
    struct Day {
        int year, month, day;
    };
    std::vector<Span> m_hours[7]; ///< Monday first.
    std::vector<Day> m_closed;
    std::optional<int> m_restart;
    bool m_hasHours = false;
};

/// The answer of adjtimex(2), and timex::status. A call that failed does not count as an answer.
bool isKernelSynchronised(int state, int status);

/// Whether the clock can be trusted: the kernel says that it is synchronised, or systemd-timesyncd has left
/// its mark below `root`.
bool isClockSynchronised(const std::string& root = {});

} // namespace kiosk
