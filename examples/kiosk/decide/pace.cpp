// SPDX-License-Identifier: MIT
#include "kiosk/decide/pace.h"

#include <algorithm>
#include <cmath>

namespace kiosk {

namespace {

// What the clocks of screen and processor disagree in so long a time is far less than a refresh.
constexpr Time kKnown = std::chrono::seconds(1);

} // namespace

void Pace::configure(double most, int refreshMilliHertz) {
    m_least = toTime(1 / most);
    m_period = Time(refreshMilliHertz > 0 ? 1'000'000'000'000 / refreshMilliHertz : 0);
    // 59.94 Hz has room for 60 frames a second.
    const double refreshes = std::ceil(refreshMilliHertz / 1000.0 / most - 0.01);
    m_refreshes = std::max(1, static_cast<int>(refreshes));
}

bool Pace::knowsRefreshes(Time now) const {
    return m_period.count() > 0 && m_refresh.count() > 0 && now - m_refresh < kKnown;
}

Time Pace::justAfterRefresh(Time now) const {
    const Time since = (now - m_refresh) % m_period;
    return since <= m_period / 8 ? now : now - since + m_period + m_period / 16;
}

void Pace::shown(Time refresh) {
    m_refresh = refresh;
    m_planned.reset();
}

void Pace::begun(Time now) {
    m_planned.reset();
    m_earliest = now + m_least;
    if (m_period.count() > 0 && m_refreshes == 1)
        m_earliest = now; // The screen takes the next one only once it shows this one.
    else if (knowsRefreshes(now))
        m_earliest = now - (now - m_refresh) % m_period + m_refreshes * m_period + m_period / 16;
}

Time Pace::plan(Time now) const {
    const Time allowed = std::max(now, m_earliest);
    const bool follows = m_refreshes == 1 && allowed - m_refresh < m_period;
    return knowsRefreshes(allowed) && !follows ? justAfterRefresh(allowed) : allowed;
}

Time Pace::next(Time now) {
    if (!m_planned)
        m_planned = plan(now);
    return std::max(now, *m_planned);
}

} // namespace kiosk
