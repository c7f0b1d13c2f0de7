// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"

#include <chrono>
#include <optional>
#include <vector>

/// Turns the raw edges of contacts into presses and steps. Uses no hardware and no clock: times are those of
/// the edges, and the caller is told how long to wait.
namespace franken {
namespace FRANKEN_API platform {

/// What a button was asked for.
enum class Press {
    Down,  ///< It was pressed. Comes before one of the others.
    Short, ///< It was released again soon.
    Long,  ///< It has been held for PressOptions::longPress; comes while it is held.
    Double ///< It was pressed a second time; comes at that press.
};

/// "down", "short", "long" or "double".
const char* toString(Press press);

/// What counts as which press.
struct PressOptions {
    /// A contact that has not changed for this long has settled; shorter changes are bounce.
    std::chrono::milliseconds settle{10};
    std::chrono::milliseconds longPress{800}; ///< How long a button is held for a long press.
    /// Two presses with less than this between them are a double press. A Short press is reported only after
    /// this time; 0: no double presses, and no delay.
    std::chrono::milliseconds doublePress{0};
};

/// A change of a contact.
struct ContactEdge {
    bool active;                   ///< Closed now.
    std::chrono::nanoseconds time; ///< By any clock that does not jump.
};

/// Filters the edges of a bouncing contact: only lasting ones remain.
class Debouncer {
public:
    /// Begins with the contact as it is.
    Debouncer(bool active, std::chrono::nanoseconds settle) : m_active(active), m_settle(settle) {}

    /// Takes a raw edge. Returns the change before it, if that has lasted.
    std::optional<ContactEdge> edge(const ContactEdge& raw);
    /// Call it when no edge has come for the settling time, with the level that was read then, because edges
    /// may have been lost. Returns the change, if there is one; its time is that of the first unsettled edge.
    std::optional<ContactEdge> settled(bool active);
    /// Whether settled() has to be called.
    bool unsettled() const { return m_burst.has_value(); }

private:
    std::optional<ContactEdge> accept(bool active);

    bool m_active;
    std::chrono::nanoseconds m_settle;
    std::optional<std::chrono::nanoseconds> m_burst; ///< The first edge of those that are not settled yet.
    ContactEdge m_last{};
};

/// Turns the lasting edges of a button into presses.
class PressRecogniser {
public:
    /// Begins with the button up.
    explicit PressRecogniser(const PressOptions& options) : m_options(options) {}

    /// A press that was recognised.
    struct Event {
        Press press;
        std::chrono::nanoseconds time; ///< When it was decided.
    };

    /// Takes a lasting edge; appends what it decides.
    void edge(const ContactEdge& edge, std::vector<Event>& events);
    /// How long after the last edge expired() has to be called, unless another edge comes.
    std::optional<std::chrono::nanoseconds> patience() const;
    /// Call it after patience(); appends what the silence decides.
    void expired(std::vector<Event>& events);

private:
    enum class State { Up, Down, Held, MaybeDouble, DoubleDown };
    void pressed(std::chrono::nanoseconds time, std::vector<Event>& events);
    void released(std::chrono::nanoseconds time, std::vector<Event>& events);

    PressOptions m_options;
    State m_state = State::Up;
    std::chrono::nanoseconds m_time{0}; ///< Of the last edge.
};

/// Turns the edges of a rotary encoder's two contacts into steps, by the Gray code. A bounce goes there and
/// back; a jump to a state that is no neighbour of the last one (lost edges) counts as no transition.
class EncoderDecoder {
public:
    /// Begins with the contacts as they are. transitionsPerStep: 4, 2 or 1.
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
