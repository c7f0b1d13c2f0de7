// SPDX-License-Identifier: MIT
#pragma once

#include "franken/image.h"
#include "franken/log.h"
#include "kiosk/report/background_task.h"

#include <filesystem>
#include <functional>

namespace kiosk {

/// Copies what the screen shows, on any thread; once.
using PictureSource = std::function<franken::Result<franken::Image>()>;

/// Copies, compresses and writes pictures on a thread of its own, so that no frame waits for the disk.
class Screenshots {
public:
    Screenshots(std::filesystem::path folder, franken::Log log)
        : m_folder(std::move(folder)), m_log(std::move(log)) {}

    /// Whether the picture before is not written yet.
    bool areBusy() const { return m_task.runs(); }
    /// Writes screenshot.png into the folder. Without a folder, the log says that there is none. Only while
    /// none is being written.
    void write(PictureSource picture);

private:
    std::filesystem::path m_folder;
    franken::Log m_log;
    BackgroundTask m_task;
};

} // namespace kiosk
