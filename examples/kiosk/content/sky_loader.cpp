// SPDX-License-Identifier: MIT
#include "kiosk/content/sky_loader.h"

#include <sys/eventfd.h>
#include <unistd.h>

namespace kiosk {

SkyLoader::SkyLoader() : m_done(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {}

SkyLoader::~SkyLoader() {
    if (m_thread.joinable())
        m_thread.join();
    close(m_done);
}

void SkyLoader::request(const std::filesystem::path& path) {
    if (m_thread.joinable())
        m_thread.join();
    m_thread = std::jthread([this, path] {
        franken::Result<franken::BakedSky> sky =
            franken::loadSky(path, {.sun = true, .progress = {}, .limits = {}});
        const std::lock_guard lock(m_mutex);
        m_sky = sky ? Sky(std::make_shared<const franken::BakedSky>(*std::move(sky))) : Sky(sky.error());
        eventfd_write(m_done, 1);
    });
}

std::optional<SkyLoader::Sky> SkyLoader::take() {
    eventfd_t count = 0;
    eventfd_read(m_done, &count);
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_sky, std::nullopt);
}

} // namespace kiosk
