// SPDX-License-Identifier: MIT
#include "kiosk/decide/timetable.h"

#include "kiosk/config/checks.h"

#include <sys/timex.h>
#include <unistd.h>

#include <algorithm>

namespace kiosk {

namespace {
int minuteOf(const std::tm& local) { return local.tm_hour * 60 + local.tm_min; }
} // namespace

Timetable::Timetable(const Config& config) {
    for (std::size_t day = 0; day < config.hours.size(); ++day)
        for (const std::string& text : config.hours[day]) {
            const Hours hours = *parseHours(text);
            m_hours[day].push_back({hours.from, hours.to});
            m_hasHours = true;
        }
    for (const std::string& text : config.timetable.closed) {
        const Date date = *parseDate(text);
        m_closed.push_back({date.year, date.month, date.day});
    }
    if (!config.timetable.restart.empty())
        m_restart = *parseClock(config.timetable.restart);
}

bool Timetable::isOpen(const std::tm& local) const {
    const auto isToday = [&local](const Day& day) {
        return (day.year == 0 || day.year == local.tm_year + 1900) && day.month == local.tm_mon + 1 &&
               day.day == local.tm_mday;
    };
    if (std::any_of(m_closed.begin(), m_closed.end(), isToday))
        return false;
    if (!m_hasHours)
        return true;
    const auto& hours = m_hours[(local.tm_wday + 6) % 7];
    return std::any_of(hours.begin(), hours.end(), [minute = minuteOf(local)](const Span& span) {
        return minute >= span.from && minute < span.to;
    });
}

int Timetable::secondsToLook(const std::tm& local) const { return std::max(1, 60 - local.tm_sec); }

bool Timetable::isRestartDue(const std::tm& local) const { return m_restart == minuteOf(local); }

bool isKernelSynchronised(int state, int status) {
    return state >= 0 && state != TIME_ERROR && (status & STA_UNSYNC) == 0;
}

bool isClockSynchronised(const std::string& root) {
    timex query{};
    const int state = adjtimex(&query); // Below 0 where a sandbox forbids the question.
    return isKernelSynchronised(state, query.status) ||
           access((root + "/run/systemd/timesync/synchronized").c_str(), F_OK) == 0;
}

} // namespace kiosk
