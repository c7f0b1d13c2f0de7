// SPDX-License-Identifier: MIT
#pragma once

#include "kiosk/event_loop.h"

namespace kiosk {

struct Shift {
    int x = 0, y = 0; ///< Pixels.
    bool operator==(const Shift&) const = default;
};

/// Where texts stand, so that they do not burn into the screen: they walk round a square, one pixel a minute.
/// `reach`: half its edge, pixels.
inline Shift wander(Time now, int reach) {
    if (reach <= 0)
        return {};
    const int edge = 2 * reach;
    const auto at =
        static_cast<int>(std::chrono::duration_cast<std::chrono::minutes>(now).count() % (4 * edge));
    const int along = at % edge - reach;
    switch (at / edge) {
    case 0:
        return {along, -reach};
    case 1:
        return {reach, along};
    case 2:
        return {-along, reach};
    default:
        return {-reach, -along};
    }
}

/// When wander() next gives another place.
inline Time nextWander(Time now) {
    return std::chrono::floor<std::chrono::minutes>(now) + std::chrono::minutes(1);
}

} // namespace kiosk
