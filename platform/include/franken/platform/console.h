// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/result.h"

#include <memory>
#include <string>

namespace franken {
namespace FRANKEN_API platform {

/// The calls of a virtual console that this library makes: what a test puts a fake in place of.
class ConsoleCalls {
public:
    virtual ~ConsoleCalls() = default;
    /// 0 or a negative errno, as ioctl() sets it.
    virtual int call(unsigned long request, unsigned long argument) = 0;
};

/// The virtual console that a kiosk runs on. While it lives, the console reads no keys (what is typed into
/// the kiosk would run in the login shell behind it), draws nothing (its text, its cursor, its blanking), and
/// asks before another one is switched to. All of that is put back when it goes, also by std::exit(); after a
/// crash or SIGKILL by `TTYReset=yes` in the unit, which should have `Conflicts=getty@tty1.service` as well,
/// or by the next Console that goes.
///
/// One in a process: the kernel tells of switches by two signals (SIGRTMIN and SIGRTMIN+1), which it takes.
class Console {
public:
    /// The path of a console, "/dev/tty1"; empty: the one that is shown. Fails with `console.missing` (none
    /// is there: a kernel without, a container), `console.permission`, and with `console.busy` for a second
    /// one.
    static Result<std::unique_ptr<Console>> open(const std::string& path = {});
    /// With calls of one's own.
    static Result<std::unique_ptr<Console>> open(std::unique_ptr<ConsoleCalls> calls);
    ~Console();

    /// Polls as readable when dispatch() has something to do.
    int descriptor() const;

    enum class Event {
        None,
        Leaving, ///< Another console is asked for: pause the surface; when it is Paused, call left().
        Returned ///< It is this one's turn again: resume the surface.
    };
    Event dispatch();
    /// The screen is given up: the kernel may switch.
    Result<void> left();

    /// Puts everything back; the destructor does so as well.
    void restore();

private:
    explicit Console(std::unique_ptr<ConsoleCalls> calls);
    Result<void> take();

    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace platform
} // namespace franken
