// SPDX-License-Identifier: MIT
#include "franken/manifest.h"

#include "franken/generator/manifest.h"

#include "franken/file.h"
#include "franken/file_writer.h"
#include "manifest_text.h"

#include <algorithm>

namespace franken {
namespace {

namespace fs = std::filesystem;

constexpr char kAnotherName[] = "name another file, or take this one away";

/// What a manifest would be written over.
struct Existing {
    enum class Kind : std::uint8_t {
        Nothing, ///< No file, a damaged one, or another version's: written anew.
        Ours,
        ByHand, ///< With comments that we would not write again.
        Stream, ///< No regular file: written to as it is.
    };
    Kind kind = Kind::Nothing;
    std::string text;
    ManifestContents contents;
};

Error writeError(const Error& error) { return {"manifest.write", error.where, error.what, error.remedy}; }

Error foreign(const fs::path& file, const std::string& why) {
    return {"manifest.foreign", file.string(), "it is no manifest, and is left as it is: " + why,
            kAnotherName};
}

// A file that cannot be read or that someone else made is an error: nothing is lost by a disk's bad day.
Result<Existing> look(const fs::path& file, const SnippetSet& snippets) {
    std::error_code ignored;
    const fs::file_status status = fs::status(file, ignored);
    if (fs::is_fifo(status)) // Opening it would wait for a reader, and it keeps nothing.
        return foreign(file, "it is a pipe");
    if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status))
        return Existing{Existing::Kind::Stream, "", {}};
    auto bytes = readFileIfThere(file, kMaxManifestBytes);
    if (!bytes && bytes.error().code == "file.size")
        return foreign(file, bytes.error().what);
    if (!bytes)
        return writeError(bytes.error());
    if (!*bytes)
        return Existing{};
    std::string text((*bytes)->begin(), (*bytes)->end());
    if (isTorn(text))
        return Existing{};
    auto contents = readContents(text, file.string(), snippets);
    if (contents)
        return Existing{isByUs(text) ? Existing::Kind::Ours : Existing::Kind::ByHand, std::move(text),
                        *std::move(contents)};
    if (contents.error().code == "manifest.damaged" || contents.error().code == "manifest.schema")
        return Existing{};
    if (contents.error().code == "manifest.empty")
        return Existing{Existing::Kind::ByHand, std::move(text), {}};
    return foreign(file, contents.error().where + ": " + contents.error().what);
}

Result<void> write(const fs::path& file, const std::string& text) {
    if (text.size() > kMaxManifestBytes)
        return Error{"manifest.size", file.string(), "it would be larger than 1 MiB",
                     "delete it; it will be written again"};
    if (const Result<void> written = writeFile(file, text); !written)
        return writeError(written.error());
    return {};
}

std::vector<ProgramUse> missingIn(const std::vector<ProgramUse>& known, std::span<const ProgramUse> uses) {
    std::vector<ProgramUse> missing;
    for (const ProgramUse& use : uses)
        if (std::find(known.begin(), known.end(), use) == known.end() &&
            std::find(missing.begin(), missing.end(), use) == missing.end())
            missing.push_back(use);
    return missing;
}

} // namespace

Result<std::vector<ProgramUse>> readManifest(const fs::path& file, const SnippetSet& snippets,
                                             const Log& log) {
    const Result<std::vector<std::uint8_t>> bytes = readFile(file, kMaxManifestBytes);
    if (!bytes && bytes.error().code == "file.size")
        return Error{"manifest.size", file.string(), bytes.error().what,
                     "remove programs that are not needed"};
    if (!bytes)
        return Error{"manifest.read", file.string(), bytes.error().what,
                     "nothing at a first start: it is written after the first program that was missing"};
    const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    return parseManifest(text, file.string(), snippets, log);
}

std::vector<ProgramUse> readManifestOrNothing(const fs::path& file, const Log& log,
                                              const SnippetSet& snippets) {
    Result<std::vector<ProgramUse>> uses = readManifest(file, snippets, log);
    if (uses)
        return *std::move(uses);
    if (log)
        log(LogLevel::Warning, "the manifest is not used for the warm-up: " + toString(uses.error()));
    return {};
}

Result<void> writeManifest(const fs::path& file, std::span<const ProgramUse> uses,
                           const SnippetSet& snippets) {
    const Result<FileLock> lock = FileLock::take(file);
    if (!lock)
        return writeError(lock.error());
    const Result<Existing> existing = look(file, snippets);
    if (!existing)
        return existing.error();
    if (existing->kind == Existing::Kind::ByHand)
        return foreign(file, "someone wrote it by hand");
    return write(file, toManifest(uses, snippets));
}

Result<void> appendToManifest(const fs::path& file, std::span<const ProgramUse> uses,
                              const SnippetSet& snippets) {
    const Result<FileLock> lock = FileLock::take(file);
    if (!lock)
        return writeError(lock.error());
    Result<Existing> existing = look(file, snippets);
    if (!existing)
        return existing.error();
    std::vector<ProgramUse> missing = missingIn(existing->contents.uses, uses);
    if (missing.empty())
        return {};
    if (existing->kind == Existing::Kind::ByHand) {
        std::string& text = existing->text;
        if (!text.empty() && text.back() != '\n')
            text += '\n';
        return write(file, text + manifestLinesOf(missing, snippets));
    }
    std::vector<ProgramUse> all = std::move(existing->contents.uses);
    all.insert(all.end(), missing.begin(), missing.end());
    std::string lines = manifestLinesOf(all, snippets);
    // An effect that is missing here may be another run's; a text that is gone is not kept.
    for (const SkippedLine& skipped : existing->contents.skipped)
        if (skipped.error.code == "effect.missing")
            lines += skipped.text;
    return write(file, manifestOfLines(lines));
}

} // namespace franken
