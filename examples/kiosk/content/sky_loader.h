// SPDX-License-Identifier: MIT
#pragma once

#include "franken/baked_sky.h"

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace kiosk {

/// Reads a sky on a thread of its own: filtering one that is not baked takes most of a minute.
class SkyLoader {
public:
    using Sky = franken::Result<std::shared_ptr<const franken::BakedSky>>;

    SkyLoader();
    ~SkyLoader();
    SkyLoader(const SkyLoader&) = delete;
    SkyLoader& operator=(const SkyLoader&) = delete;

    /// Waits for one that is being read before.
    void request(const std::filesystem::path& path);
    /// Polls as readable when take() has something.
    int descriptor() const { return m_done; }
    std::optional<Sky> take();

private:
    int m_done;
    std::mutex m_mutex;
    std::optional<Sky> m_sky;
    std::jthread m_thread;
};

} // namespace kiosk
