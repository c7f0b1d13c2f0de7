// SPDX-License-Identifier: MIT
#include "kiosk/control/gestures.h"

#include <algorithm>
#include <cmath>

namespace kiosk {

namespace platform = franken::platform;
using platform::Point;
using platform::TouchEvent;

namespace {

constexpr double kStill = 0.02;  // Of the picture: less is no move.
constexpr double kSwipe = 0.15;  // Of the picture.
constexpr double kPinched = 1.3; // Fingers that part or close so much do not swipe.
constexpr auto kTap = std::chrono::milliseconds(400);
constexpr auto kDoubleTap = std::chrono::milliseconds(500);

double distance(const Point& a, const Point& b) { return std::hypot(a.x - b.x, a.y - b.y); }

} // namespace

void Gestures::moved(Finger& finger, const Point& to, Moves& moves) {
    const Point by{to.x - finger.last.x, to.y - finger.last.y};
    const auto count = static_cast<double>(m_fingers.size());
    m_travel = {m_travel.x + by.x / count, m_travel.y + by.y / count};
    if (m_most == 1) {
        moves.dragX += by.x;
        moves.dragY += by.y;
    }
    if (m_fingers.size() == 2) {
        const Finger& first = m_fingers.begin()->second;
        const Point& other = &first == &finger ? m_fingers.rbegin()->second.last : first.last;
        const double before = std::max(distance(finger.last, other), 1e-3);
        const double factor = std::max(distance(to, other), 1e-3) / before;
        m_spread *= factor;
        moves.zoom /= factor;
    }
    finger.last = to;
}

void Gestures::ended(Moment time, Moves& moves) {
    const double way = std::hypot(m_travel.x, m_travel.y);
    if (m_cancelled || m_most > 2)
        return;
    if (m_most == 1 && way < kStill && time - m_began < kTap) {
        const bool isDouble = m_hasTap && time - m_lastTap < kDoubleTap;
        moves.names.emplace_back(isDouble ? "double-tap" : "tap");
        m_hasTap = !isDouble;
        m_lastTap = time;
    }
    const bool isPinch = m_spread > kPinched || m_spread < 1 / kPinched;
    if (m_most != 2 || way < kSwipe || isPinch)
        return;
    if (std::abs(m_travel.x) > std::abs(m_travel.y))
        moves.names.emplace_back(m_travel.x < 0 ? "swipe-left" : "swipe-right");
    else if (m_travel.y < 0)
        moves.names.emplace_back("swipe-up");
}

Gestures::Moves Gestures::take(const TouchEvent& event) {
    Moves moves;
    switch (event.kind) {
    case TouchEvent::Kind::Down:
        if (m_fingers.empty()) {
            m_began = event.time;
            m_travel = {};
            m_most = 0;
            m_spread = 1;
            m_cancelled = false;
        }
        m_fingers[event.finger] = {event.position};
        m_most = std::max(m_most, m_fingers.size());
        break;
    case TouchEvent::Kind::Move:
        if (const auto finger = m_fingers.find(event.finger); finger != m_fingers.end())
            moved(finger->second, event.position, moves);
        break;
    case TouchEvent::Kind::Cancel:
        m_cancelled = true;
        [[fallthrough]];
    case TouchEvent::Kind::Up:
        if (m_fingers.erase(event.finger) != 0 && m_fingers.empty())
            ended(event.time, moves);
        break;
    }
    return moves;
}

} // namespace kiosk
