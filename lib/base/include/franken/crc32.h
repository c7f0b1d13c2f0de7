// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"

#include <cstdint>
#include <string_view>

namespace FRANKEN_API franken {

/// CRC-32 as in ISO 3309 (zlib's, PNG's): reflected, polynomial 0x04C11DB7. Any thread.
constexpr std::uint32_t crc32(std::string_view text) {
    std::uint32_t crc = ~0u;
    for (const char c : text) {
        crc ^= static_cast<std::uint8_t>(c);
        for (int bit = 0; bit < 8; ++bit)
            crc = crc >> 1 ^ ((crc & 1u) != 0 ? 0xEDB88320u : 0u);
    }
    return ~crc;
}

} // namespace franken
