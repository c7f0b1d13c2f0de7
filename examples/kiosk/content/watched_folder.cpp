// SPDX-License-Identifier: MIT
#include "kiosk/content/watched_folder.h"

#include <algorithm>
#include <utility>

namespace kiosk {

namespace fs = std::filesystem;
using franken::LogLevel;

namespace {

constexpr std::uint32_t kGone = IN_MOVE_SELF | IN_DELETE_SELF | IN_UNMOUNT;
constexpr std::uint32_t kEvents = IN_CREATE | IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_DELETE |
                                  IN_MOVE_SELF | IN_DELETE_SELF | IN_ONLYDIR;

bool isHidden(const fs::path& path) { return path.filename().string().starts_with('.'); }

bool isModel(const fs::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return extension == ".glb" || extension == ".gltf";
}

/// What is in a folder and not hidden; nothing where it cannot be read.
std::vector<fs::directory_entry> entriesOf(const fs::path& folder) {
    std::vector<fs::directory_entry> entries;
    std::error_code error;
    for (fs::directory_iterator each(folder, error), end; !error && each != end; each.increment(error))
        if (!isHidden(each->path()))
            entries.push_back(*each);
    return entries;
}

bool isFolder(const fs::directory_entry& entry) {
    std::error_code error;
    return entry.is_directory(error);
}

/// Nobody writes to it through this name: it is there at once, and nothing is closed.
bool isLink(const fs::path& path) {
    std::error_code error;
    const std::uintmax_t names = fs::hard_link_count(path, error);
    return fs::is_symlink(path, error) || (!error && names > 1);
}

} // namespace

WatchedFolder::WatchedFolder(fs::path folder, franken::Log log)
    : m_folder(std::move(folder)), m_log(std::move(log)) {
    rescan();
}

void WatchedFolder::watch(const fs::path& folder) {
    const franken::Result<int> watched = m_inotify.watch(folder, kEvents);
    if (watched) {
        const auto [first, last] = m_folders.equal_range(*watched);
        if (std::none_of(first, last, [&folder](const auto& entry) { return entry.second == folder; }))
            m_folders.emplace(*watched, folder);
    }
    if (watched || watched.error().code == "kiosk.missing")
        m_unwatched.erase(folder);
    else if (m_unwatched.insert(folder).second)
        m_log(LogLevel::Warning, "looked at every few seconds: " + franken::toString(watched.error()));
}

void WatchedFolder::rescan() {
    std::erase_if(m_unwatched, [](const fs::path& folder) {
        std::error_code error;
        return !fs::exists(folder, error);
    });
    const std::multimap<int, fs::path> before = std::exchange(m_folders, {});
    watch(m_folder);
    for (const fs::directory_entry& entry : foldersIn())
        watch(entry.path());
    for (const auto& entry : before) { // Links may be gone, or lead to other folders.
        const auto [first, last] = m_folders.equal_range(entry.first);
        if (std::find(first, last, entry) == last)
            forgetWriting(entry.second);
        if (first == last)
            m_inotify.unwatch(entry.first);
    }
}

/// But for a link to the folder itself, in which all models would be once more.
std::vector<fs::directory_entry> WatchedFolder::foldersIn() const {
    std::vector<fs::directory_entry> folders = entriesOf(m_folder);
    std::erase_if(folders, [this](const fs::directory_entry& entry) {
        std::error_code error;
        return !isFolder(entry) || fs::equivalent(entry.path(), m_folder, error);
    });
    return folders;
}

bool WatchedFolder::present() const {
    return std::any_of(m_folders.begin(), m_folders.end(),
                       [this](const auto& entry) { return entry.second == m_folder; });
}

bool WatchedFolder::handle(const inotify_event& event, std::vector<fs::path>& changed) {
    if ((event.mask & IN_Q_OVERFLOW) != 0) {
        m_beingWritten.clear(); // What was closed meanwhile will not be heard of again.
        return true;
    }
    const auto [first, last] = m_folders.equal_range(event.wd);
    if (first == last)
        return false;
    if ((event.mask & (kGone | IN_IGNORED)) != 0) {
        forget(event.wd);
        return true;
    }
    if ((event.mask & IN_ISDIR) != 0)
        return true;
    for (auto folder = first; folder != last; ++folder)
        note(event.len == 0 ? folder->second : folder->second / event.name, event.mask, changed);
    return event.len != 0 && isFolderName(first->second / event.name);
}

/// A link to a folder comes and goes as a file does, and so does the name of one that is watched.
bool WatchedFolder::isFolderName(const fs::path& path) const {
    std::error_code error;
    return fs::is_directory(path, error) ||
           std::any_of(m_folders.begin(), m_folders.end(),
                       [&path](const auto& entry) { return entry.second == path; });
}

/// What was being written there may be complete when it is seen again.
void WatchedFolder::forgetWriting(const fs::path& folder) {
    std::erase_if(m_beingWritten, [&folder](const fs::path& file) { return file.parent_path() == folder; });
}

void WatchedFolder::forget(int watch) {
    const auto [first, last] = m_folders.equal_range(watch);
    for (auto folder = first; folder != last; ++folder)
        forgetWriting(folder->second);
    m_inotify.unwatch(watch);
    m_folders.erase(first, last);
}

void WatchedFolder::note(const fs::path& path, std::uint32_t events, std::vector<fs::path>& changed) {
    if (isHidden(path))
        return;
    if ((events & IN_CREATE) != 0 && !isLink(path)) {
        m_beingWritten.insert(path);
        return;
    }
    m_beingWritten.erase(path);
    changed.push_back(path);
}

std::vector<fs::path> WatchedFolder::dispatch() {
    std::vector<fs::path> changed;
    bool isStale = false;
    m_inotify.read([&](const inotify_event& event) { isStale = handle(event, changed) || isStale; });
    if (isStale) {
        rescan();
        changed.push_back(m_folder);
    }
    return changed;
}

std::vector<fs::path> WatchedFolder::models() const {
    std::vector<fs::path> models;
    const auto add = [&](const fs::directory_entry& entry) {
        std::error_code error;
        if (isModel(entry.path()) && entry.is_regular_file(error) && !m_beingWritten.contains(entry.path()))
            models.push_back(entry.path());
    };
    for (const fs::directory_entry& entry : entriesOf(m_folder))
        add(entry);
    for (const fs::directory_entry& folder : foldersIn())
        for (const fs::directory_entry& entry : entriesOf(folder.path()))
            add(entry);
    std::sort(models.begin(), models.end());
    return models;
}

} // namespace kiosk
