// SPDX-License-Identifier: MIT
#include "manifest.h"

#include <array>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <unistd.h>

namespace franken::cli {
namespace {

constexpr char kNameAList[] = "name a file that lists permutations, one a line";

Error unreadable(const std::string& file) {
    return {"manifest.read", file, std::string("cannot be read: ") + std::strerror(errno), kNameAList};
}

// Pipes have no size to be asked for: what comes is counted.
Result<void> readAll(int descriptor, Manifest& manifest) {
    std::array<char, 65536> block;
    while (true) {
        const ssize_t count = read(descriptor, block.data(), block.size());
        if (count < 0 && errno == EINTR)
            continue;
        if (count < 0)
            return unreadable(manifest.file);
        if (count == 0)
            return {};
        manifest.text.append(block.data(), static_cast<std::size_t>(count));
        if (manifest.text.size() > kMaxListBytes)
            return Error{"manifest.size", manifest.file,
                         "the file is larger than 4 MiB, and so not a list of names", kNameAList};
    }
}

} // namespace

Result<std::unique_ptr<Manifest>> readManifest(const std::string& file) {
    const bool standardInput = file == "-";
    auto manifest = std::make_unique<Manifest>();
    manifest->file = standardInput ? "<stdin>" : file;
    const int descriptor = standardInput ? STDIN_FILENO : open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY);
    if (descriptor < 0)
        return unreadable(file);
    const Result<void> read = readAll(descriptor, *manifest);
    if (!standardInput)
        close(descriptor);
    if (!read)
        return read.error();
    Result<ManifestLines> parsed = parseManifestLines(manifest->text, manifest->file);
    if (!parsed)
        return parsed.error();
    manifest->lines = std::move(parsed->lines);
    return manifest;
}

} // namespace franken::cli
