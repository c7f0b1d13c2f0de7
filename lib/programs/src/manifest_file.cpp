// SPDX-License-Identifier: MIT
#include "franken/manifest.h"

#include "franken/file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <unistd.h>

namespace franken {
namespace {

namespace fs = std::filesystem;

bool writeAll(int descriptor, std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(descriptor, text.data(), text.size());
        if (written < 0 && errno != EINTR)
            return false;
        text.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
    }
    return true;
}

bool writeToDisk(const fs::path& file, std::string_view text) {
    const Descriptor out(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0644));
    return out && writeAll(out.number(), text) && ::fsync(out.number()) == 0;
}

} // namespace

Result<std::vector<ProgramUse>> readManifest(const fs::path& file) {
    const Result<std::vector<std::uint8_t>> bytes = readFile(file, kMaxManifestBytes);
    if (!bytes && bytes.error().code == "file.size")
        return Error{"manifest.size", file.string(), bytes.error().what, "keep what is needed"};
    if (!bytes)
        return Error{"manifest.read", file.string(), bytes.error().what,
                     "nothing, at a first start: it is written when something was missing"};
    const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    return parseManifest(text, file.string());
}

std::vector<ProgramUse> readManifestOrNothing(const fs::path& file, const Log& log) {
    Result<std::vector<ProgramUse>> uses = readManifest(file);
    if (uses)
        return *std::move(uses);
    if (log)
        log(LogLevel::Warning, "nothing is warmed up from the manifest: " + toString(uses.error()));
    return {};
}

Result<void> writeManifest(const fs::path& file, std::span<const ProgramUse> uses) {
    const fs::path part = file.string() + ".part";
    if (!writeToDisk(part, toManifest(uses)) || ::rename(part.c_str(), file.c_str()) != 0) {
        const std::string reason = std::strerror(errno);
        ::unlink(part.c_str());
        return Error{"manifest.write", file.string(), "cannot be written: " + reason,
                     "name a file on a disk that has room and can be written"};
    }
    // So that the new name outlives a power cut as well; where a file system cannot, it did what it can.
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    if (const Descriptor directory(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)); directory)
        ::fsync(directory.number());
    return {};
}

Result<void> appendToManifest(const fs::path& file, std::span<const ProgramUse> uses) {
    Result<std::vector<ProgramUse>> known = readManifest(file);
    std::vector<ProgramUse> all = known ? *std::move(known) : std::vector<ProgramUse>();
    const std::size_t before = all.size();
    for (const ProgramUse& use : uses)
        if (std::find(all.begin(), all.end(), use) == all.end())
            all.push_back(use);
    if (all.size() == before)
        return {};
    if (toManifest(all).size() > kMaxManifestBytes)
        return Error{"manifest.size", file.string(), "it would be larger than 1 MiB",
                     "delete it: it is written anew"};
    return writeManifest(file, all);
}

} // namespace franken
