// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/result.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace franken {
namespace FRANKEN_API platform {

/// CRC-32 (ISO 3309, as in PNG and gzip) of a range of bytes, for example a frame's pixels.
std::uint32_t crc32(const void* data, std::size_t bytes);

/// Writes one line, "FRAMES CHECKSUM", by which another process can see that the picture changes: the number
/// of frames shown, and the checksum of the last one in hexadecimal. The file is replaced as a whole. Fails
/// with `heartbeat.file` (a full or read-only disk); the old file then stays.
Result<void> writeHeartbeat(const std::string& file, std::uint64_t frames, std::uint32_t checksum);

} // namespace platform
} // namespace franken
