// SPDX-License-Identifier: MIT
#include "franken/platform/service.h"

#include "descriptor.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <cstring>

namespace franken::platform {

namespace {

std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

std::optional<std::int64_t> number(const std::string& text) {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() && value > 0 ? std::optional(value)
                                                                                 : std::nullopt;
}

} // namespace

ServiceManager::ServiceManager() : m_socket(variable("NOTIFY_SOCKET")) {
    const std::string process = variable("WATCHDOG_PID");
    const std::optional<std::int64_t> microseconds = number(variable("WATCHDOG_USEC"));
    if (microseconds && (process.empty() || number(process) == getpid()))
        m_interval = std::chrono::microseconds(*microseconds / 2);
}

Result<void> ServiceManager::send(const std::string& message) const {
    if (!present())
        return {};
    sockaddr_un address = {};
    address.sun_family = AF_UNIX;
    if (m_socket.size() >= sizeof address.sun_path || (m_socket[0] != '/' && m_socket[0] != '@'))
        return Error{"service.socket", m_socket, "NOTIFY_SOCKET is not the path of a socket",
                     "unset NOTIFY_SOCKET"};
    std::memcpy(address.sun_path, m_socket.data(), m_socket.size());
    if (m_socket[0] == '@') // An abstract name begins with a zero.
        address.sun_path[0] = '\0';
    const FileDescriptor socket(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + m_socket.size());
    if (sendto(socket.get(), message.data(), message.size(), MSG_NOSIGNAL,
               reinterpret_cast<const sockaddr*>(&address), length) < 0)
        return Error{"service.socket", m_socket, std::strerror(errno),
                     "check that the service manager listens"};
    return {};
}

Result<void> ServiceManager::sendStatus() {
    const std::string line = m_text.empty() ? m_state : m_state + ": " + m_text;
    if (line == m_sent)
        return {};
    m_sent = line;
    return send("STATUS=" + line);
}

Result<void> ServiceManager::ready(std::string_view state) {
    m_state = state;
    if (!m_ready) {
        m_ready = true;
        if (Result<void> sent = send("READY=1"); !sent)
            return sent;
    }
    return sendStatus();
}

Result<void> ServiceManager::status(std::string_view text) {
    m_text.clear();
    for (const char c : text)
        m_text += c == '\n' ? ' ' : c; // The protocol's separator.
    return sendStatus();
}

Result<void> ServiceManager::alive() {
    const Nanoseconds now = monotonicNow();
    if (!m_interval || (m_lastAlive.count() != 0 && now - m_lastAlive < *m_interval / 2))
        return {};
    m_lastAlive = now;
    return send("WATCHDOG=1");
}

Result<void> ServiceManager::stopping() { return send("STOPPING=1"); }

} // namespace franken::platform
