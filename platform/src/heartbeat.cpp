// SPDX-License-Identifier: MIT
#include "franken/platform/heartbeat.h"

#include "descriptor.h"
#include "franken/crc32.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace franken::platform {

std::uint32_t crc32(const void* data, std::size_t bytes) {
    return franken::crc32({static_cast<const char*>(data), bytes});
}

Result<void> writeHeartbeat(const std::string& file, std::uint64_t frames, std::uint32_t checksum) {
    char line[48];
    const int length =
        std::snprintf(line, sizeof line, "%llu %08x\n", static_cast<unsigned long long>(frames), checksum);
    const std::string part = file + ".part";
    const auto failed = [&] {
        Error error{"heartbeat.file", file, std::strerror(errno),
                    "name a file on a disk that has room, such as /run"};
        unlink(part.c_str());
        return error;
    };
    {
        const FileDescriptor out(open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
        if (!out || write(out.get(), line, static_cast<std::size_t>(length)) != length)
            return failed();
    }
    if (rename(part.c_str(), file.c_str()) != 0)
        return failed();
    return {};
}

} // namespace franken::platform
