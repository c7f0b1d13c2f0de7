// SPDX-License-Identifier: MIT
#include "diff_folder.h"

#include "folder_manifest.h"
#include "franken/file.h"
#include "program.h"
#include "selection.h"
#include "unified_diff.h"

namespace franken::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxManifestBytes = std::size_t{64} << 20U; // Of 15,000 programs.
constexpr std::size_t kMaxTextBytes = std::size_t{1} << 20U;

Error refused(const fs::path& file, const std::string& why) {
    return {"diff.folder", file.string(), why, "name a folder that 'frankenshader dump -o' wrote"};
}

Result<std::string> readText(const fs::path& file, std::size_t maxBytes) {
    const Result<std::vector<std::uint8_t>> bytes = readFile(file, maxBytes);
    if (!bytes)
        return refused(file, bytes.error().what);
    return std::string(bytes->begin(), bytes->end());
}

Result<std::string> readStage(const fs::path& folder, const ListedProgram& program, const char* stage,
                              const fs::path& name) {
    if (name.empty() || name.has_parent_path())
        return refused(folder / "manifest.json", "it names no file beside it for the " + std::string(stage) +
                                                     " shader of '" + program.name + "'");
    return readText(folder / name, kMaxTextBytes);
}

Result<FolderProgram> compare(const fs::path& folder, const ListedProgram& program) {
    FolderProgram result{program.name, "", "", ""};
    const Result<std::string> vertex = readStage(folder, program, "vertex", program.vertex);
    const Result<std::string> fragment = readStage(folder, program, "fragment", program.fragment);
    if (!vertex || !fragment)
        return (vertex ? fragment : vertex).error();
    const Result<Canonical> canonical = readName(result.name);
    if (!canonical) {
        result.refused = canonical.error().what;
        return result;
    }
    const Program today(canonical->permutation);
    const std::string before = (folder / result.name).string();
    result.vertex = unifiedDiff(before + ".vert", *vertex, today.name + ".vert", today.composed.vertex.text);
    result.fragment =
        unifiedDiff(before + ".frag", *fragment, today.name + ".frag", today.composed.fragment.text);
    return result;
}

} // namespace

Result<std::vector<FolderProgram>> compareFolder(const fs::path& folder) {
    const fs::path file = folder / "manifest.json";
    const Result<std::string> text = readText(file, kMaxManifestBytes);
    if (!text)
        return text.error();
    const Result<std::vector<ListedProgram>> programs = parseFolderManifest(*text);
    if (!programs)
        return refused(file, programs.error().what);
    std::vector<FolderProgram> all;
    for (const ListedProgram& program : *programs) {
        Result<FolderProgram> compared = compare(folder, program);
        if (!compared)
            return compared.error();
        all.push_back(*std::move(compared));
    }
    return all;
}

} // namespace franken::cli
