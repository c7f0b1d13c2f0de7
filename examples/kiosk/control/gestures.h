// SPDX-License-Identifier: MIT
#pragma once

#include "franken/platform/input.h"

#include <chrono>
#include <map>
#include <string>
#include <vector>

namespace kiosk {

/// Moves of fingers: one turns the model, two that part or close zoom, two that go the same way swipe. Pure.
class Gestures {
public:
    using Moment = std::chrono::microseconds;

    struct Moves {
        double dragX = 0, dragY = 0;    ///< Parts of the picture's width and height.
        double zoom = 1;                ///< Factor of the distance.
        std::vector<std::string> names; ///< "tap", "double-tap", "swipe-left", ...
    };
    Moves take(const franken::platform::TouchEvent& event);

private:
    struct Finger {
        franken::platform::Point last;
    };
    void moved(Finger& finger, const franken::platform::Point& to, Moves& moves);
    void ended(Moment time, Moves& moves);

    std::map<int, Finger> m_fingers;
    Moment m_began{0}, m_lastTap{0};
    franken::platform::Point m_travel; ///< The mean way of all fingers since the first came.
    std::size_t m_most = 0;            ///< Fingers at a time.
    double m_spread = 1;               ///< Distance of two fingers now over that at first.
    bool m_hasTap = false, m_cancelled = false;
};

} // namespace kiosk
