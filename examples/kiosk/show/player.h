// SPDX-License-Identifier: MIT
#pragma once

#include "franken/pose.h"

namespace kiosk {

/// Plays all animations of a scene, one after the other, again and again. Each goes round once, or as often
/// as it takes to last kLeastSeconds, and fades into the next, which goes on meanwhile. One alone goes round.
class Player {
public:
    static constexpr double kLeastSeconds = 4, kFadeSeconds = 0.5;

    /// Goes on by so many seconds, 0 or more, and poses the scene, which is the same each time and has an
    /// animation. Allocates where it is called first, and where it first
    /// fades.
    void advance(const franken::Scene& scene, double seconds);

    /// As it was left by advance().
    const franken::Pose& pose() const { return m_pose; }

private:
    int m_animation = 0; ///< That plays.
    double m_time = 0;   ///< Of it, seconds.
    franken::Pose m_rest, m_pose, m_next;
};

} // namespace kiosk
