// SPDX-License-Identifier: MIT
#include "kiosk/config/file_watch.h"

#include <utility>

namespace kiosk {

FileWatch::FileWatch(EventLoop& loop, const std::filesystem::path& file, const franken::Log& log,
                     EventLoop::Handler changed, Time look)
    : m_file(std::filesystem::absolute(file)), m_changed(std::move(changed)), m_look(look), m_stamp(stamp()) {
    const auto watched = m_inotify.watch(m_file.parent_path(), IN_CLOSE_WRITE | IN_MOVED_TO);
    if (watched) {
        m_source = loop.onReadable(m_inotify.descriptor(), [this] { dispatch(); });
        return;
    }
    log(franken::LogLevel::Warning,
        m_file.string() + " is looked at every few seconds: " + franken::toString(watched.error()));
    m_timer = loop.timer([this] { this->look(); });
    m_timer->arm(now() + m_look);
}

FileWatch::Stamp FileWatch::stamp() const {
    std::error_code time, size;
    return {std::filesystem::last_write_time(m_file, time), std::filesystem::file_size(m_file, size)};
}

void FileWatch::dispatch() {
    bool isChanged = false;
    m_inotify.read([&](const inotify_event& event) {
        isChanged = isChanged || (event.mask & IN_Q_OVERFLOW) != 0 ||
                    (event.len > 0 && m_file.filename() == event.name);
    });
    if (isChanged)
        m_changed();
}

void FileWatch::look() {
    const Stamp found = stamp();
    if (std::exchange(m_stamp, found) != found)
        m_changed();
    m_timer->arm(now() + m_look);
}

} // namespace kiosk
