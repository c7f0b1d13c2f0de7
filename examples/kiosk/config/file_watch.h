// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace kiosk {

/// Notices when a file was written or replaced, as editors do.
class FileWatch {
public:
    explicit FileWatch(const std::filesystem::path& file);
    ~FileWatch();
    FileWatch(const FileWatch&) = delete;
    FileWatch& operator=(const FileWatch&) = delete;

    /// A descriptor that is readable when something in the file's folder changed; -1 where it cannot be
    /// watched.
    int descriptor() const { return m_inotify; }
    /// Whether it was the file.
    bool dispatch();

private:
    std::string m_name;
    int m_inotify;
};

} // namespace kiosk
