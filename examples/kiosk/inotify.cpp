// SPDX-License-Identifier: MIT
#include "kiosk/inotify.h"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace kiosk {

Inotify::Inotify() : m_descriptor(inotify_init1(IN_CLOEXEC | IN_NONBLOCK)), m_refusal(errno) {}

Inotify::~Inotify() {
    if (m_descriptor >= 0)
        close(m_descriptor);
}

franken::Result<int> Inotify::watch(const std::filesystem::path& folder, std::uint32_t events) {
    const int watch = m_descriptor < 0 ? -1 : inotify_add_watch(m_descriptor, folder.c_str(), events);
    if (watch >= 0)
        return watch;
    const int reason = m_descriptor < 0 ? m_refusal : errno;
    return franken::Error{reason == ENOENT ? "kiosk.missing" : "kiosk.unwatched", folder.string(),
                          std::string("cannot be watched: ") + std::strerror(reason),
                          "raise fs.inotify.max_user_watches and max_user_instances by sysctl where they "
                          "are used up"};
}

void Inotify::read(const std::function<void(const inotify_event&)>& take) {
    alignas(inotify_event) std::array<char, 16384> buffer{};
    for (ssize_t got = 0; (got = ::read(m_descriptor, buffer.data(), buffer.size())) > 0;)
        for (std::size_t at = 0; at < static_cast<std::size_t>(got);) {
            const auto& event = *reinterpret_cast<const inotify_event*>(buffer.data() + at);
            at += sizeof(inotify_event) + event.len;
            take(event);
        }
}

} // namespace kiosk
