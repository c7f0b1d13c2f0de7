// SPDX-License-Identifier: MIT
#pragma once

#include "franken/result.h"

#include <sys/inotify.h>

#include <cstdint>
#include <filesystem>
#include <functional>

namespace kiosk {

/// An instance of inotify(7).
class Inotify {
public:
    Inotify();
    ~Inotify();
    Inotify(const Inotify&) = delete;
    Inotify& operator=(const Inotify&) = delete;

    /// Readable when there are events; -1 where the kernel gives no instance.
    int descriptor() const { return m_descriptor; }
    /// The watch descriptor. Fails with "kiosk.unwatched", or "kiosk.missing" where nothing is there.
    franken::Result<int> watch(const std::filesystem::path& folder, std::uint32_t events);
    void unwatch(int watch) { inotify_rm_watch(m_descriptor, watch); }
    /// Hands over what has happened.
    void read(const std::function<void(const inotify_event&)>& take);

private:
    int m_descriptor;
    int m_refusal; ///< Why there is no instance.
};

} // namespace kiosk
