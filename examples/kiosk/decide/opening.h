// SPDX-License-Identifier: MIT
#pragma once

#include "kiosk/decide/presence.h"
#include "kiosk/decide/timetable.h"

#include <string>

namespace kiosk {

/// Whether the screen shall be dark, and why: the shop is closed, or nobody is there. Pure: the caller passes
/// the time.
class Opening {
public:
    void configure(const Config& config) {
        m_timetable = Timetable(config);
        presence.setIdleTime(toTime(60 * config.presence.idleMinutes));
    }

    Presence presence;

    /// Empty: light. The timetable is not heeded while the clock is not synchronised.
    std::string darkBecause(Time now, const std::tm& local, bool isSynchronised) const {
        if (isSynchronised && !m_timetable.isOpen(local))
            return "closed";
        return presence.isThere(now) ? "" : "nobody is there";
    }
    /// When darkBecause() may change by itself.
    Time nextLook(Time now, const std::tm& local) const {
        const Time minute = now + std::chrono::seconds(m_timetable.secondsToLook(local));
        const Time end = presence.end();
        return end > now && end < minute ? end : minute;
    }
    bool isRestartDue(const std::tm& local, bool isSynchronised) const {
        return isSynchronised && m_timetable.isRestartDue(local);
    }

private:
    Timetable m_timetable;
};

} // namespace kiosk
