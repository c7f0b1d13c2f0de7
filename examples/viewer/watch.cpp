// SPDX-License-Identifier: MIT
#include "watch.h"

#include <chrono>
#include <csignal>
#include <iostream>
#include <map>
#include <set>
#include <thread>

namespace fs = std::filesystem;

namespace {

volatile std::sig_atomic_t stopped = 0;

using Times = std::map<fs::path, std::pair<fs::file_time_type, std::uintmax_t>>; ///< And sizes.

bool isOfModel(const fs::path& file) {
    static const std::set<fs::path> kExtensions = {".gltf", ".glb", ".bin", ".png", ".jpg", ".jpeg"};
    return kExtensions.contains(file.extension());
}

// A file that is being replaced may be gone in the middle of it.
void addFile(Times& times, const fs::path& file) {
    std::error_code error;
    const auto time = fs::last_write_time(file, error);
    const std::uintmax_t size = fs::file_size(file, error);
    if (!error)
        times[file] = {time, size};
}

template<typename Wanted>
void addFolder(Times& times, const fs::path& folder, int depth, const Wanted& wanted) {
    std::error_code error;
    for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        if (entry.depth() >= depth)
            entry.disable_recursion_pending();
        if (wanted(entry->path()))
            addFile(times, entry->path());
    }
}

/// Of the model, of the files in its folder and the folders therein that may belong to it, and of the
/// snippets.
Times timesOf(const Options& options) {
    Times times;
    addFile(times, options.model);
    addFolder(times, fs::absolute(options.model).parent_path(), 1,
              [&](const fs::path& file) { return isOfModel(file) && file != fs::absolute(options.output); });
    if (!options.snippets.empty())
        addFolder(times, options.snippets, 1,
                  [](const fs::path& file) { return file.extension() == ".glsl"; });
    return times;
}

// Until two looks in a row see the same: editors write in steps.
Times settledTimes(const Options& options) {
    Times before = timesOf(options);
    while (stopped == 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        Times now = timesOf(options);
        if (now == before)
            break;
        before = std::move(now);
    }
    return before;
}

} // namespace

void watch(Session& session, const Options& options) {
    for (const int signal : {SIGINT, SIGTERM})
        std::signal(signal, [](int) { stopped = 1; });
    while (stopped == 0) {
        const Times drawn = settledTimes(options);
        if (const std::optional<Failure> failure = session.draw())
            std::cerr << "viewer: error: " << toString(failure->error)
                      << "\nviewer: kept the last good picture\n";
        else
            std::cerr << "viewer: wrote " << options.output.string() << "\n";
        while (stopped == 0 && timesOf(options) == drawn)
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
}
