// SPDX-License-Identifier: MIT
#include "franken/platform/press.h"

namespace franken::platform {

using std::chrono::nanoseconds;

const char* toString(Press press) {
    constexpr const char* kNames[] = {"down", "short", "long", "double"}; // In the order of the enumeration.
    return kNames[static_cast<std::size_t>(press)];
}

std::optional<ContactEdge> Debouncer::accept(bool active) {
    const nanoseconds time = *m_burst;
    m_burst.reset();
    if (active == m_active)
        return std::nullopt;
    m_active = active;
    return ContactEdge{active, time};
}

std::optional<ContactEdge> Debouncer::edge(const ContactEdge& raw) {
    std::optional<ContactEdge> before;
    if (m_burst && raw.time - m_last.time >= m_settle)
        before = accept(m_last.active);
    if (!m_burst)
        m_burst = raw.time;
    m_last = raw;
    return before;
}

std::optional<ContactEdge> Debouncer::settled(bool active) { return m_burst ? accept(active) : std::nullopt; }

void PressRecogniser::edge(const ContactEdge& edge, std::vector<Event>& events) {
    // What should have expired before this edge did, however late the caller is.
    if (const auto limit = patience(); limit && edge.time - m_time >= *limit)
        expired(events);
    if (edge.active)
        pressed(edge.time, events);
    else
        released(edge.time, events);
    m_time = edge.time;
}

void PressRecogniser::pressed(nanoseconds time, std::vector<Event>& events) {
    events.push_back({Press::Down, time});
    if (m_state == State::MaybeDouble) {
        events.push_back({Press::Double, time});
        m_state = State::DoubleDown;
    } else {
        m_state = State::Down;
    }
}

void PressRecogniser::released(nanoseconds time, std::vector<Event>& events) {
    if (m_state != State::Down) {
        m_state = State::Up;
    } else if (m_options.doublePress.count() > 0) {
        m_state = State::MaybeDouble;
    } else {
        events.push_back({Press::Short, time});
        m_state = State::Up;
    }
}

std::optional<nanoseconds> PressRecogniser::patience() const {
    if (m_state == State::Down)
        return m_options.longPress;
    if (m_state == State::MaybeDouble)
        return m_options.doublePress;
    return std::nullopt;
}

void PressRecogniser::expired(std::vector<Event>& events) {
    if (m_state == State::Down) {
        events.push_back({Press::Long, m_time + m_options.longPress});
        m_state = State::Held;
    } else if (m_state == State::MaybeDouble) {
        events.push_back({Press::Short, m_time});
        m_state = State::Up;
    }
}

int EncoderDecoder::edge(bool isB, bool active) {
    (isB ? m_b : m_a) = active;
    const int code = codeOf(m_a, m_b);
    const int turn = (code - m_code) & 3;
    m_code = code;
    if (turn == 1)
        ++m_transitions;
    else if (turn == 3)
        --m_transitions;
    const int steps = m_transitions / m_perStep;
    m_transitions -= steps * m_perStep;
    return steps;
}

} // namespace franken::platform
