// SPDX-License-Identifier: MIT
#include "effects.h"

#include "franken/file.h"
#include "franken/generator/effect.h"

#include <algorithm>

namespace franken::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxEffectBytes = std::size_t{64} << 10;

struct Added {
    SnippetSet snippets = SnippetSet::builtIn();
    std::vector<fs::path> files;
};

Added& added() {
    static Added all;
    return all;
}

Result<void> addEffect(const fs::path& file) {
    const Result<std::vector<std::uint8_t>> bytes = readFile(file, kMaxEffectBytes);
    if (!bytes)
        return Error{"effect.file", bytes.error().where, bytes.error().what,
                     "name a file of GLSL, or a folder of them"};
    const std::string text(bytes->begin(), bytes->end());
    const Result<Effect> effect = Effect::parse(file.stem().string(), text, file.string());
    if (!effect)
        return effect.error();
    Result<SnippetSet> set = snippets().with(*effect);
    if (!set)
        return set.error();
    added().snippets = *std::move(set);
    added().files.push_back(file);
    return {};
}

// Sorted: slots, and so keys, do not depend on the file system.
std::vector<fs::path> filesIn(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code failed;
    for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed))
        if (entry->path().extension() == ".glsl")
            files.push_back(entry->path());
    std::sort(files.begin(), files.end());
    return files;
}

} // namespace

const SnippetSet& snippets() { return added().snippets; }

const std::vector<fs::path>& effectFiles() { return added().files; }

Result<void> addEffects(const std::vector<std::string>& paths) {
    for (const std::string& path : paths) {
        std::error_code ignored;
        const bool folder = fs::is_directory(path, ignored);
        const std::vector<fs::path> files = folder ? filesIn(path) : std::vector<fs::path>{path};
        if (files.empty())
            return Error{"effect.file", path, "the folder has no .glsl file",
                         "name a file of GLSL, or a folder of them"};
        for (const fs::path& file : files)
            if (Result<void> done = addEffect(file); !done)
                return done;
    }
    return {};
}

} // namespace franken::cli
