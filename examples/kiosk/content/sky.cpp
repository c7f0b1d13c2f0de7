// SPDX-License-Identifier: MIT
#include "kiosk/content/sky.h"

namespace kiosk {

franken::Result<Sky> readSky(const std::filesystem::path& path) {
    franken::Result<franken::BakedSky> sky =
        franken::loadSky(path, {.sun = true, .progress = {}, .limits = {}});
    if (!sky)
        return sky.error();
    return std::make_shared<const franken::BakedSky>(*std::move(sky));
}

} // namespace kiosk
