// SPDX-License-Identifier: MIT
#pragma once

#include "franken/log.h"
#include "kiosk/event_loop.h"
#include "kiosk/inotify.h"

#include <filesystem>
#include <memory>

namespace kiosk {

/// Notices when a file was written or replaced, as editors do: by inotify(7), or by looking at its time and
/// size every few seconds where its folder cannot be watched; the log says that once.
class FileWatch {
public:
    static constexpr Time kLook = std::chrono::seconds(5);

    /// `changed` is called for each change. `look`: how often the file is looked at where it has to be.
    FileWatch(EventLoop& loop, const std::filesystem::path& file, const franken::Log& log,
              EventLoop::Handler changed, Time look = kLook);

private:
    struct Stamp {
        std::filesystem::file_time_type time;
        std::uintmax_t size;
        bool operator==(const Stamp&) const = default;
    };
    Stamp stamp() const;
    void dispatch();
    void look();

    std::filesystem::path m_file;
    EventLoop::Handler m_changed;
    Inotify m_inotify;
    std::unique_ptr<EventLoop::Source> m_source;
    std::unique_ptr<EventLoop::Timer> m_timer; ///< Where the folder is not watched.
    Time m_look;
    Stamp m_stamp;
};

} // namespace kiosk
