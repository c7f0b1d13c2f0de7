// SPDX-License-Identifier: MIT
#pragma once

#include "franken/image.h"
#include "franken/log.h"

#include <filesystem>
#include <thread>

namespace kiosk {

/// Compresses and writes pictures on a thread of its own, so that no frame waits for the disk.
class Screenshots {
public:
    Screenshots(std::filesystem::path folder, franken::Log log)
        : m_folder(std::move(folder)), m_log(std::move(log)) {}

    /// Writes screenshot.png into the folder; waits for the picture before, if that is not written yet.
    /// Without a folder, the log says that there is none.
    void write(franken::Image picture);

private:
    std::filesystem::path m_folder;
    franken::Log m_log;
    std::jthread m_thread;
};

} // namespace kiosk
