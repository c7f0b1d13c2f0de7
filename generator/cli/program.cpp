// SPDX-License-Identifier: MIT
#include "program.h"

#include "franken/file.h"
#include "franken/generator/effect.h"

#include <algorithm>
#include <filesystem>

namespace franken::cli {
namespace {

// File systems take 255 bytes; the longest extension is ".shader_test.part".
constexpr std::size_t kMaxFileName = 230;

constexpr std::size_t kMaxEffectBytes = std::size_t{64} << 10;

namespace fs = std::filesystem;

SnippetSet& ownSnippets() {
    static SnippetSet set = SnippetSet::builtIn();
    return set;
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
    ownSnippets() = *std::move(set);
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

const SnippetSet& snippets() { return ownSnippets(); }

Result<void> addEffects(const std::vector<std::string>& paths) {
    for (const std::string& path : paths) {
        std::error_code ignored;
        const bool folder = fs::is_directory(path, ignored);
        const std::vector<fs::path> files = folder ? filesIn(path) : std::vector<fs::path>{path};
        if (files.empty())
            return Error{"effect.file", path, "the folder has no .glsl file",
                         "name a file of GLSL, or a folder of them"};
        for (const fs::path& file : files)
            if (Result<void> added = addEffect(file); !added)
                return added;
    }
    return {};
}

Program::Program(const Permutation& canonical)
    : permutation(canonical),
      name(toName(canonical, snippets())),
      file(name.size() <= kMaxFileName ? name : toHex(toKey(canonical))),
      composed(compose(canonical, snippets())) {}

std::vector<std::string_view> linesOf(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

} // namespace franken::cli
