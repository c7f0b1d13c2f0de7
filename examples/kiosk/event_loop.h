// SPDX-License-Identifier: MIT
#pragma once

#include "franken/result.h"

#include <chrono>
#include <functional>
#include <initializer_list>
#include <memory>

namespace kiosk {

/// CLOCK_MONOTONIC, which no setting of the clock moves.
using Time = std::chrono::nanoseconds;
Time now();
/// From a number of seconds.
inline Time toTime(double seconds) {
    return std::chrono::duration_cast<Time>(std::chrono::duration<double>(seconds));
}

/// What the kiosk waits for, by libsystemd's sd-event: descriptors, timers, signals.
class EventLoop {
public:
    using Handler = std::function<void()>;

    /// Blocks the signals that onSignal() will take. Must run before any thread starts, which inherits that.
    static franken::Result<std::unique_ptr<EventLoop>> make(std::initializer_list<int> signals = {});
    ~EventLoop();

    /// A source that ends with it.
    class Source {
    public:
        virtual ~Source() = default;
    };
    /// `handler` runs whenever the descriptor is readable. Null where the loop cannot watch it.
    std::unique_ptr<Source> onReadable(int descriptor, Handler handler);
    /// One of the signals that make() was given.
    std::unique_ptr<Source> onSignal(int number, Handler handler);
    /// `handler` runs whenever the system's clock was set, forwards or back.
    std::unique_ptr<Source> onClockSet(Handler handler);

    class Timer : public Source {
    public:
        /// Runs its handler once, then; a later arm() replaces an earlier one.
        virtual void arm(Time when) = 0;
        virtual void disarm() = 0;
    };
    std::unique_ptr<Timer> timer(Handler handler);

    /// Waits for the next event and handles it.
    franken::Result<void> turn();

private:
    struct State;
    explicit EventLoop(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

} // namespace kiosk
