// SPDX-License-Identifier: MIT
#include "kiosk/config/file_watch.h"

#include <sys/inotify.h>
#include <unistd.h>

#include <array>

namespace kiosk {

FileWatch::FileWatch(const std::filesystem::path& file)
    : m_name(file.filename().string()), m_inotify(inotify_init1(IN_CLOEXEC | IN_NONBLOCK)) {
    const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
    inotify_add_watch(m_inotify, folder.c_str(), IN_CLOSE_WRITE | IN_MOVED_TO);
}

FileWatch::~FileWatch() {
    if (m_inotify >= 0)
        close(m_inotify);
}

bool FileWatch::dispatch() {
    bool isChanged = false;
    alignas(inotify_event) std::array<char, 4096> buffer{};
    for (ssize_t got = 0; (got = read(m_inotify, buffer.data(), buffer.size())) > 0;)
        for (std::size_t at = 0; at < static_cast<std::size_t>(got);) {
            const auto& event = *reinterpret_cast<const inotify_event*>(buffer.data() + at);
            at += sizeof(inotify_event) + event.len;
            isChanged =
                isChanged || (event.mask & IN_Q_OVERFLOW) != 0 || (event.len > 0 && m_name == event.name);
        }
    return isChanged;
}

} // namespace kiosk
