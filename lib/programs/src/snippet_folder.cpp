// SPDX-License-Identifier: MIT
#include "franken/snippet_folder.h"

#include "franken/file.h"
#include "franken/printable.h"

namespace franken {
namespace {

constexpr std::size_t kMaxFileBytes = std::size_t{64} * 1024;

Result<std::string> readText(const std::filesystem::path& path, const char* remedy) {
    const Result<std::vector<std::uint8_t>> bytes = readFile(path, kMaxFileBytes);
    if (!bytes || bytes->empty())
        return Error{"snippet.file", path.string(), bytes ? "the file is empty" : bytes.error().what, remedy};
    const std::string text(bytes->begin(), bytes->end());
    return std::string(withoutByteOrderMark(text));
}

} // namespace

Result<SnippetSet> readSnippets(const std::filesystem::path& folder) {
    std::string name = folder.string();
    while (name.size() > 1 && name.ends_with('/'))
        name.pop_back();
    return SnippetSet::make(
        [&](std::string_view snippet) {
            return readText(folder / (std::string(snippet) + ".glsl"),
                            "give a folder that is laid out as generator/glsl is");
        },
        std::move(name));
}

Result<Effect> readEffect(const std::filesystem::path& file) {
    const Result<std::string> text = readText(file, "give a file of GLSL with the sections of an effect");
    if (!text)
        return text.error();
    return Effect::parse(file.stem().string(), *text, file.string());
}

} // namespace franken
