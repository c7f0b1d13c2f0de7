// SPDX-License-Identifier: MIT
// Any bytes as a manifest: each entry says where it stands, and its name can be parsed or refused.
#include <string>

#include <sys/mman.h>
#include <unistd.h>

#include "franken/generator/permutation.h"
#include "manifest.h"
#include "require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace franken;
    static const int kFile = memfd_create("manifest", 0);
    static const std::string kPath = "/proc/self/fd/" + std::to_string(kFile);
    require(ftruncate(kFile, 0) == 0 && pwrite(kFile, data, size, 0) == static_cast<ssize_t>(size), "a file");
    const auto entries = cli::readManifest(kPath);
    require(entries.has_value(), "a readable file");
    for (const cli::ManifestEntry& entry : *entries) {
        require(entry.where.starts_with(kPath + ":") && !entry.name.empty(), "a place and a name");
        const auto permutation = parseName(entry.name);
        require(permutation || permutation.error().code.starts_with("permutation."), "a documented code");
    }
    return 0;
}
