// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/result.h"

#include <memory>
#include <string>

namespace franken {
namespace FRANKEN_API platform {

/// The calls to a virtual console; tests replace them by a fake.
class ConsoleCalls {
public:
    virtual ~ConsoleCalls() = default;
    /// 0 or a negative errno, as ioctl() sets it.
    virtual int call(unsigned long request, unsigned long argument) = 0;
};

/// The virtual console of a kiosk. While this object lives, the console reads no keys (text typed into the
/// kiosk would run in the login shell behind it), draws nothing (no text, no cursor, no blanking), and asks
/// before another console is shown. The destructor restores all of that, also at std::exit(); after a crash
/// or SIGKILL, `TTYReset=yes` in the unit does (the unit should have `Conflicts=getty@tty1.service` as well),
/// or the destructor of the next Console.
///
/// Only one Console per process: the kernel announces switches by two signals (SIGRTMIN and SIGRTMIN+1),
/// which it handles.
class Console {
public:
    /// The path of a console, "/dev/tty1"; empty: the one that is shown. Fails with `console.missing` (none
    /// is there: a kernel without, a container), `console.permission`, and with `console.busy` for a second
    /// one.
    static Result<std::unique_ptr<Console>> open(const std::string& path = {});
    /// Opens a console with replaced calls.
    static Result<std::unique_ptr<Console>> open(std::unique_ptr<ConsoleCalls> calls);
    ~Console();

    /// Polls as readable when dispatch() has something to do.
    int descriptor() const;

    /// What dispatch() found.
    enum class Event {
        None,
        Leaving, ///< Another console is asked for: pause the surface; when it is Paused, call left().
        Returned ///< This console is shown again: resume the surface.
    };
    Event dispatch(); ///< Call it when the descriptor is readable.
    /// Tells the kernel that the screen is free and that it may switch.
    Result<void> left();

    /// Restores the console; the destructor does so as well.
    void restore();

private:
    explicit Console(std::unique_ptr<ConsoleCalls> calls);
    Result<void> take();

    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace platform
} // namespace franken
