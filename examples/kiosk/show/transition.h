// SPDX-License-Identifier: MIT
#pragma once

#include "kiosk/event_loop.h"

namespace kiosk {

/// The change from one model to the next: through the background, and only once the next one is ready. Pure:
/// the caller passes the time.
class Transition {
public:
    enum class Phase { Empty, Showing, FadingOut, FadingIn };

    /// `stay` of 0: until next() is called.
    void configure(Time fade, Time stay) { m_fade = fade, m_stay = stay; }

    /// Somebody asked for another model: it comes as soon as it is ready.
    void next() { m_asked = true; }
    bool isAsked() const { return m_asked; }
    /// The shown model goes, whether or not another one is ready.
    void leave() { m_leaves = m_phase != Phase::Empty; }
    bool leaves() const { return m_leaves; }

    /// Whether the models change now: the picture is all background. After leave(), the phase is Empty then
    /// where none is ready. `isReady`: the next one can be drawn.
    bool advance(Time now, bool isReady);

    /// 0: all of the model, 1: all background.
    double cover(Time now) const;
    Phase phase() const { return m_phase; }
    /// When the model's time is up; 0 without an end.
    Time end() const { return m_stay.count() == 0 ? Time{0} : m_since + m_stay; }
    /// The shown model was taken away.
    void clear() { m_phase = Phase::Empty, m_leaves = false; }

private:
    double progress(Time now) const;

    Phase m_phase = Phase::Empty;
    Time m_fade{0}, m_stay{0};
    Time m_since{0}; ///< Of the phase.
    bool m_asked = false, m_leaves = false;
};

} // namespace kiosk
