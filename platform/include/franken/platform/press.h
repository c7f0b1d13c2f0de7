// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"

#include <chrono>
#include <optional>
#include <vector>

/// What the raw edges of contacts mean. No hardware and no clock in here: times are those of the edges, and
/// whoever waits is told for how long.
namespace franken {
namespace FRANKEN_API platform {

enum class Press {
    Down,  ///< It was pressed. Comes before one of the others.
    Short, ///< It was released again soon.
    Long,  ///< It has been held for PressOptions::longPress; comes while it is held.
    Double ///< It was pressed a second time; comes at that press.
};

/// "down", "short", "long" or "double".
const char* toString(Press press);

struct PressOptions {
    /// A contact that has not changed for so long has settled; what is shorter is bounce.
    std::chrono::milliseconds settle{10};
    std::chrono::milliseconds longPress{800};
    /// Two presses with less than this between them are a double one. A Short is told only after so long; 0:
    /// no double presses, and no wait.
    std::chrono::milliseconds doublePress{0};
};

struct ContactEdge {
    bool active;
    std::chrono::nanoseconds time;
};

/// From the edges of a bouncing contact to those that last.
class Debouncer {
public:
    Debouncer(bool active, std::chrono::nanoseconds settle) : m_active(active), m_settle(settle) {}

    /// A raw edge. Returns the change before it, if that had lasted.
    std::optional<ContactEdge> edge(const ContactEdge& raw);
    /// When nothing has come for the settling time: the contact's level is what it is read as, whatever edges
    /// were lost. Returns the change, if it is one; its time is that of the burst's first edge.
    std::optional<ContactEdge> settled(bool active);
    /// Whether settled() is waited for.
    bool unsettled() const { return m_burst.has_value(); }

private:
    std::optional<ContactEdge> accept(bool active);

    bool m_active;
    std::chrono::nanoseconds m_settle;
    std::optional<std::chrono::nanoseconds> m_burst; ///< The first edge of those that are not settled yet.
    ContactEdge m_last{};
};

/// From the lasting edges of a button to presses.
class PressRecogniser {
public:
    explicit PressRecogniser(const PressOptions& options) : m_options(options) {}

    struct Event {
        Press press;
        std::chrono::nanoseconds time;
    };

    void edge(const ContactEdge& edge, std::vector<Event>& events);
    /// So long after the last edge expired() is due, unless another edge comes.
    std::optional<std::chrono::nanoseconds> patience() const;
    void expired(std::vector<Event>& events);

private:
    enum class State { Up, Down, Held, MaybeDouble, DoubleDown };
    void pressed(std::chrono::nanoseconds time, std::vector<Event>& events);
    void released(std::chrono::nanoseconds time, std::vector<Event>& events);

    PressOptions m_options;
    State m_state = State::Up;
    std::chrono::nanoseconds m_time{0}; ///< Of the last edge.
};

/// From the two contacts of a rotary encoder to steps, by the Gray code: a bounce goes there and back, and
/// what is no neighbour of the state before was lost and counts as nothing.
class EncoderDecoder {
public:
    EncoderDecoder(bool a, bool b, int transitionsPerStep)
        : m_code(codeOf(a, b)), m_perStep(transitionsPerStep), m_a(a), m_b(b) {}
    /// The steps that this edge completes: -1, 0 or 1.
    int edge(bool isB, bool active);

private:
    static int codeOf(bool a, bool b) { return (a ? 1 : 0) ^ (b ? 3 : 0); }
    int m_code, m_perStep, m_transitions = 0;
    bool m_a, m_b;
};

} // namespace platform
} // namespace franken
