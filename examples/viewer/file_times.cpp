// SPDX-License-Identifier: MIT
#include "file_times.h"

#include <set>
#include <system_error>

namespace fs = std::filesystem;

namespace {

using Extensions = std::set<fs::path>;

// A file that is being replaced may be gone in the middle of it.
void addFile(FileTimes& times, const fs::path& file) {
    std::error_code error;
    const auto time = fs::last_write_time(file, error);
    const std::uintmax_t size = fs::file_size(file, error);
    if (!error)
        times[file] = {time, size};
}

// But for the picture that is drawn, which may lie among them.
void addFolder(FileTimes& times, const fs::path& folder, int depth, const Extensions& extensions,
               const Options& options) {
    std::error_code error;
    for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        if (entry.depth() >= depth)
            entry.disable_recursion_pending();
        if (extensions.contains(entry->path().extension()) &&
            fs::absolute(entry->path()) != fs::absolute(options.output))
            addFile(times, entry->path());
    }
}

} // namespace

FileTimes skyTimes(const Options& options) {
    FileTimes times;
    std::error_code ignored;
    if (fs::is_directory(options.skybox, ignored))
        addFolder(times, options.skybox, 0, {".hdr", ".png", ".jpg", ".jpeg"}, options);
    else if (!options.skybox.empty())
        addFile(times, options.skybox);
    return times;
}

FileTimes inputTimes(const Options& options) {
    FileTimes times = skyTimes(options);
    addFile(times, options.model);
    addFolder(times, fs::absolute(options.model).parent_path(), 1,
              {".gltf", ".glb", ".bin", ".png", ".jpg", ".jpeg"}, options);
    if (!options.heightMap.empty())
        addFile(times, options.heightMap);
    if (!options.effect.empty())
        addFile(times, options.effect);
    if (!options.snippets.empty())
        addFolder(times, options.snippets, 2, {".glsl"}, options);
    return times;
}
