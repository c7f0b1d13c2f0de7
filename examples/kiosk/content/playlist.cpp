// SPDX-License-Identifier: MIT
#include "kiosk/content/playlist.h"

#include <algorithm>

namespace kiosk {

void Playlist::set(std::vector<Path> models) {
    m_models = std::move(models);
    std::erase_if(m_broken, [this](const auto& entry) { return !contains(entry.first); });
}

std::optional<Playlist::Path> Playlist::after(const std::optional<Path>& shown, int direction) const {
    const auto count = static_cast<int>(m_models.size());
    int at = direction > 0 ? -1 : count;
    if (shown) {
        const auto found = std::find(m_models.begin(), m_models.end(), *shown);
        // A model that has gone is followed by the one that would have followed it.
        const auto place = found != m_models.end()
                               ? found
                               : std::find_if(m_models.begin(), m_models.end(),
                                              [&](const Path& path) { return path > *shown; });
        at = static_cast<int>(place - m_models.begin());
        if (found == m_models.end() && direction > 0)
            --at;
    }
    for (int step = 1; step <= count; ++step) {
        const int next = ((at + direction * step) % count + count) % count;
        const Path& model = m_models[static_cast<std::size_t>(next)];
        if (!m_broken.contains(model))
            return model;
    }
    return {};
}

void Playlist::markBroken(const Path& model, std::string reason) { m_broken[model] = std::move(reason); }

void Playlist::changed(const Path& file) {
    std::erase_if(m_broken, [&file](const auto& entry) {
        return isBelow(file, entry.first.parent_path()) || isBelow(entry.first, file);
    });
}

bool Playlist::isBelow(const Path& path, const Path& folder) {
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

bool Playlist::contains(const Path& model) const {
    return std::find(m_models.begin(), m_models.end(), model) != m_models.end();
}

} // namespace kiosk
