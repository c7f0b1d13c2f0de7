// SPDX-License-Identifier: MIT
#include "manifest.h"

#include "franken/generator/manifest.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>

namespace franken::cli {
namespace {

constexpr std::size_t kMaxBytes = 64U << 20U;

Error unreadable(const std::string& file) {
    return {"manifest.read", file, std::string("cannot be read: ") + std::strerror(errno),
            "name a file that lists permutations, one a line"};
}

Result<std::vector<ManifestEntry>> readFrom(std::istream& in, const std::string& file) {
    std::string text;
    errno = 0;
    for (std::string line; std::getline(in, line);) {
        if (text.size() + line.size() > kMaxBytes)
            return Error{"manifest.size", file, "this is no list of names: it is larger than 64 MiB",
                         "name a file that lists permutations, one a line"};
        text += line + '\n';
    }
    if (in.bad())
        return unreadable(file);
    std::vector<ManifestEntry> entries;
    for (const ManifestLine& line : manifestLines(text))
        entries.push_back({std::string(line.name), file + ":" + std::to_string(line.number)});
    return entries;
}

} // namespace

Result<std::vector<ManifestEntry>> readManifest(const std::string& file) {
    if (file == "-")
        return readFrom(std::cin, "<stdin>");
    std::ifstream in(file);
    if (!in)
        return unreadable(file);
    return readFrom(in, file);
}

} // namespace franken::cli
