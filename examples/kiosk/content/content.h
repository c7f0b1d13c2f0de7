// SPDX-License-Identifier: MIT
#pragma once

#include "franken/log.h"
#include "kiosk/config/config.h"
#include "kiosk/content/background_reader.h"
#include "kiosk/content/loader.h"
#include "kiosk/content/playlist.h"
#include "kiosk/content/watched_folder.h"
#include "kiosk/event_loop.h"

#include <atomic>
#include <memory>
#include <optional>
#include <set>
#include <string>

namespace kiosk {

/// Knows which models there are, and reads the next one ahead. Broken models are skipped, and each is
/// reported once until it changes.
class Content {
public:
    /// `arrived` is called when take() may have something, or when the list of models has changed.
    Content(EventLoop& loop, franken::Log log, EventLoop::Handler arrived);

    void configure(const Config& config);

    /// Begins to read what follows (or comes before) the model that is shown; nothing where it is alone, and
    /// its file is still the same.
    void want(const std::optional<std::filesystem::path>& shown, int direction = 1);
    /// What want() would read.
    std::optional<std::filesystem::path> following(const std::optional<std::filesystem::path>& shown,
                                                   int direction = 1) const;
    /// Whether the file, or one that it may be made of, was replaced since it was read.
    bool isReplaced(const std::filesystem::path& model) const { return m_replaced.contains(model); }
    /// Whether something is being read, or read and not taken.
    bool isReading() const { return m_reading.has_value(); }
    /// The share of what is being read that is done, 0 to 1.
    float progress() const { return m_progress; }
    void cancel();

    /// A whole model, read by want().
    std::optional<LoadedModel> take();
    /// Its upload failed.
    void refuse(const std::filesystem::path& model, const franken::Error& error);

    const Playlist& playlist() const { return m_playlist; }

private:
    void refresh();
    void folderChanged();
    void noteChange(const std::filesystem::path& file);
    void watchFolder(const std::string& folder);

    EventLoop& m_loop;
    franken::Log m_log;
    EventLoop::Handler m_arrived;
    std::vector<std::filesystem::path> m_listed; ///< By the configuration.
    std::string m_folderName;
    Playlist m_playlist;
    std::atomic<float> m_progress = 0; ///< Written by the loader's thread.
    BackgroundReader<LoadedModel> m_loader;
    std::unique_ptr<WatchedFolder> m_folder;
    std::unique_ptr<EventLoop::Source> m_loaderSource, m_folderSource;
    std::unique_ptr<EventLoop::Timer> m_folderTimer; ///< Looks for a folder that is not there.
    std::set<std::filesystem::path> m_replaced;
    std::optional<std::filesystem::path> m_reading, m_shown;
    int m_direction = 1;
};

} // namespace kiosk
