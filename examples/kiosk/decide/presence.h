// SPDX-License-Identifier: MIT
#pragma once

#include "kiosk/event_loop.h"

namespace kiosk {

/// Whether somebody is there: the sensor sees motion, or a key, button or finger moved within the idle time.
/// Pure: the caller passes the time.
class Presence {
public:
    /// 0: somebody is always there.
    void setIdleTime(Time idle) { m_idle = idle; }

    void seen(Time now) { m_last = now; }
    /// While the sensor sees motion, nobody is away.
    void setMotion(bool motion, Time now) {
        m_motion = motion;
        seen(now);
    }

    bool isThere(Time now) const { return m_idle.count() == 0 || m_motion || now < m_last + m_idle; }
    /// When isThere() will change; 0: not by time alone.
    Time end() const { return m_idle.count() == 0 || m_motion ? Time{0} : m_last + m_idle; }

private:
    Time m_idle{0}, m_last{0};
    bool m_motion = false;
};

} // namespace kiosk
