// SPDX-License-Identifier: MIT
#include "manifest.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <string_view>

namespace franken::cli {
namespace {

constexpr std::size_t kMaxBytes = 64U << 20U;

std::string_view trim(std::string_view line) {
    constexpr std::string_view kSpace = " \t\r";
    line = line.substr(0, line.find('#'));
    line.remove_prefix(std::min(line.find_first_not_of(kSpace), line.size()));
    return line.substr(0, line.find_last_not_of(kSpace) + 1);
}

Error unreadable(const std::string& file) {
    return {"manifest.read", file, std::string("cannot be read: ") + std::strerror(errno),
            "name a file that lists permutations, one a line"};
}

Result<std::vector<ManifestEntry>> readFrom(std::istream& in, const std::string& file) {
    std::vector<ManifestEntry> entries;
    std::size_t number = 0, bytes = 0;
    errno = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        bytes += line.size();
        if (bytes > kMaxBytes)
            return Error{"manifest.size", file, "this is no list of names: it is larger than 64 MiB",
                         "name a file that lists permutations, one a line"};
        if (const std::string_view name = trim(line); !name.empty())
            entries.push_back({std::string(name), file + ":" + std::to_string(number)});
    }
    if (in.bad())
        return unreadable(file);
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
