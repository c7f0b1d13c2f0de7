// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/result.h"

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace franken {
namespace FRANKEN_API platform {

/// What a service manager is told, by systemd's protocol (sd_notify(3)): a datagram to $NOTIFY_SOCKET. Does
/// nothing where there is none. The environment is read once, when it is made.
///
///     ServiceManager manager;
///     manager.ready("drawing");                  // in each turn of the loop: what has not changed is not
///     sent manager.status(surface->status()); manager.alive();
class ServiceManager {
public:
    ServiceManager();

    bool present() const { return !m_socket.empty(); }

    /// Half of WatchdogSec=: so often alive() must be called, or the manager ends the process. Nothing where
    /// the unit has none.
    std::optional<std::chrono::microseconds> watchdogInterval() const { return m_interval; }

    /// The loop runs, in that state. READY=1 is sent once, the state whenever it is another.
    Result<void> ready(std::string_view state);
    /// One line for `systemctl status`; sent whenever it is another.
    Result<void> status(std::string_view text);
    /// A turn of the loop is done. Sent at most once in a quarter of the interval.
    Result<void> alive();
    /// The process is about to end.
    Result<void> stopping();

private:
    Result<void> send(const std::string& message) const;
    Result<void> sendStatus();

    std::string m_socket, m_state, m_text, m_sent;
    std::optional<std::chrono::microseconds> m_interval;
    std::chrono::nanoseconds m_lastAlive{0};
    bool m_ready = false;
};

} // namespace platform
} // namespace franken
