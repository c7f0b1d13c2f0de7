// SPDX-License-Identifier: MIT
#pragma once

#include "kiosk/event_loop.h"

#include <optional>

namespace kiosk {

/// When frames begin: no more of them than the frame rate's limit allows, and each just after a refresh of
/// the screen, so that all of a refresh's time is left to draw it. A frame that begins just before a refresh
/// is late however little it takes to draw. Pure: the caller passes the time.
class Pace {
public:
    /// `most`: frames a second. `refreshMilliHertz`: of the screen; 0 where frames are shown at once.
    void configure(double most, int refreshMilliHertz);

    /// A frame's first pixel was scanned out then.
    void shown(Time refresh);
    void begun(Time now);

    /// When the next frame shall begin, for a caller that has one to draw now: `now` or later. A caller that
    /// asks again too late is told to begin at once.
    Time next(Time now);

private:
    Time plan(Time now) const;
    bool knowsRefreshes(Time now) const;
    Time justAfterRefresh(Time now) const;

    Time m_least{0};     ///< Between two frames.
    Time m_period{0};    ///< Of the screen; 0: frames are shown at once.
    int m_refreshes = 1; ///< From frame to frame.
    Time m_refresh{0};   ///< One whose time is known; 0: none.
    Time m_earliest{0};  ///< By the limit.
    std::optional<Time> m_planned;
};

} // namespace kiosk
