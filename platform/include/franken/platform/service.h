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

/// Reports to a service manager by systemd's protocol (sd_notify(3)): datagrams to $NOTIFY_SOCKET. Does
/// nothing without that variable. The constructor reads the environment.
///
///     ServiceManager manager;
///     // In each turn of the loop; unchanged states and texts are not sent again:
///     manager.ready("drawing");
///     manager.status(surface->status());
///     manager.alive();
class ServiceManager {
public:
    ServiceManager();

    /// There is one: systemd started the process.
    bool present() const { return !m_socket.empty(); }

    /// Half of WatchdogSec=: call alive() at least that often, or the manager ends the process. Nothing where
    /// the unit has no watchdog.
    std::optional<std::chrono::microseconds> watchdogInterval() const { return m_interval; }

    /// Reports that the loop runs, in that state. READY=1 is sent once, the state whenever it changes.
    Result<void> ready(std::string_view state);
    /// One line for `systemctl status`; sent whenever it changes.
    Result<void> status(std::string_view text);
    /// Call it in each turn of the loop. Sent at most once in a quarter of the interval.
    Result<void> alive();
    /// Reports that the process is about to end.
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
