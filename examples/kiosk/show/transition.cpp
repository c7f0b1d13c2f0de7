// SPDX-License-Identifier: MIT
#include "kiosk/show/transition.h"

#include <algorithm>

namespace kiosk {

double Transition::progress(Time now) const {
    if (m_fade.count() <= 0)
        return 1;
    const double share = static_cast<double>((now - m_since).count()) / static_cast<double>(m_fade.count());
    return std::clamp(share, 0.0, 1.0);
}

bool Transition::advance(Time now, bool isReady) {
    const auto enter = [this, now](Phase phase) { m_phase = phase, m_since = now; };
    if (m_phase == Phase::FadingIn && progress(now) >= 1)
        enter(Phase::Showing);
    if (m_phase == Phase::Showing) {
        const bool isOver = m_asked || (m_stay.count() > 0 && now >= m_since + m_stay);
        if (m_leaves || (isOver && isReady))
            enter(Phase::FadingOut);
    }
    const bool isDark = m_phase == Phase::Empty || (m_phase == Phase::FadingOut && progress(now) >= 1);
    if (isDark && m_leaves && !isReady)
        clear();
    if (!isDark || !isReady)
        return false;
    m_asked = m_leaves = false;
    enter(Phase::FadingIn);
    return true;
}

double Transition::cover(Time now) const {
    switch (m_phase) {
    case Phase::Empty:
        return 1;
    case Phase::Showing:
        return 0;
    case Phase::FadingOut:
        return progress(now);
    case Phase::FadingIn:
        return 1 - progress(now);
    }
    return 0;
}

} // namespace kiosk
