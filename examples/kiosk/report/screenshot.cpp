// SPDX-License-Identifier: MIT
#include "kiosk/report/screenshot.h"

#include "franken/png.h"

namespace kiosk {

void Screenshots::write(PictureSource picture) {
    if (m_folder.empty())
        return m_log(franken::LogLevel::Error,
                     "no screenshot: files.state is empty; set it to the folder that shall have them");
    m_task.start([file = m_folder / "screenshot.png", log = m_log, picture = std::move(picture)] {
        const franken::Result<void> written = picture().and_then(
            [&file](const franken::Image& image) { return franken::writePng(file, image); });
        if (written)
            log(franken::LogLevel::Info, "screenshot: " + file.string());
        else
            log(franken::LogLevel::Error, "no screenshot: " + franken::toString(written.error()));
    });
}

} // namespace kiosk
