// SPDX-License-Identifier: MIT
#pragma once

#include "franken/log.h"
#include "kiosk/inotify.h"

#include <filesystem>
#include <map>
#include <set>
#include <vector>

namespace kiosk {

/// A folder of models and the folders in it, watched by inotify(7). A file that is being written is not there
/// before its writer closes it, renames it to its name, or links it there; hidden files (as rsync and
/// Syncthing make while they copy) are none of ours.
class WatchedFolder {
public:
    /// The folder need not be there (yet): rescan() looks for it.
    WatchedFolder(std::filesystem::path folder, franken::Log log);

    int descriptor() const { return m_inotify.descriptor(); }
    /// Reads what happened: the files that were completed, replaced or removed; the folder itself where more
    /// may have happened in it.
    std::vector<std::filesystem::path> dispatch();
    /// Watches what is there now: for a folder that appears late (a data partition, a USB stick).
    void rescan();
    /// Whether the folder is there and watched.
    bool present() const;
    /// Whether changes are noticed by rescan() alone, in the folder or one in it.
    bool needsRescans() const { return !present() || !m_unwatched.empty(); }

    /// The .glb and .gltf files that are complete, in the order of their paths.
    std::vector<std::filesystem::path> models() const;

private:
    void watch(const std::filesystem::path& folder);
    /// Whether the folders have to be looked at again.
    bool handle(const inotify_event& event, std::vector<std::filesystem::path>& changed);
    void note(const std::filesystem::path& path, std::uint32_t events,
              std::vector<std::filesystem::path>& changed);
    bool isFolderName(const std::filesystem::path& path) const;
    void forgetWriting(const std::filesystem::path& folder);
    void forget(int watch);
    std::vector<std::filesystem::directory_entry> foldersIn() const;

    std::filesystem::path m_folder;
    franken::Log m_log;
    Inotify m_inotify;
    /// By watch descriptor: a folder that has several names, by links to it, has one.
    std::multimap<int, std::filesystem::path> m_folders;
    std::set<std::filesystem::path> m_beingWritten;
    std::set<std::filesystem::path> m_unwatched; ///< Folders that cannot be watched: each is reported once.
};

} // namespace kiosk
