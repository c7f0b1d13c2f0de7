// SPDX-License-Identifier: MIT
#include "franken/platform/heartbeat.h"

#include "franken/crc32.h"
#include "franken/file_writer.h"

#include <cstdio>
#include <string_view>

namespace franken::platform {

std::uint32_t crc32(const void* data, std::size_t bytes) {
    return franken::crc32({static_cast<const char*>(data), bytes});
}

Result<void> writeHeartbeat(const std::string& file, std::uint64_t frames, std::uint32_t checksum) {
    char line[48];
    const int length =
        std::snprintf(line, sizeof line, "%llu %08x\n", static_cast<unsigned long long>(frames), checksum);
    // Later: what matters is that it changes, not that it outlives the power.
    const Result<void> written =
        writeFile(file, std::string_view(line, static_cast<std::size_t>(length)), FileWriter::Sync::Later);
    if (!written)
        return Error{"heartbeat.file", file, written.error().what,
                     "name a file on a disk that has room, such as /run"};
    return {};
}

} // namespace franken::platform
