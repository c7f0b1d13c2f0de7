// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace franken {

/// The bytes of a font's table, big-endian. Reads outside of it give 0, so that no offset of a file is
/// dangerous; has() tells whether bytes are there.
class FontTable {
public:
    FontTable() = default;
    explicit FontTable(std::span<const std::uint8_t> bytes) : m_bytes(bytes) {}

    std::size_t size() const { return m_bytes.size(); }
    bool has(std::size_t at, std::size_t count) const {
        return at <= m_bytes.size() && count <= m_bytes.size() - at;
    }
    /// From there to its end; empty where that lies outside.
    FontTable from(std::size_t at) const { return FontTable(m_bytes.subspan(at < size() ? at : size())); }
    FontTable part(std::size_t at, std::size_t count) const {
        return has(at, count) ? FontTable(m_bytes.subspan(at, count)) : FontTable();
    }

    std::uint8_t u8(std::size_t at) const { return has(at, 1) ? m_bytes[at] : 0; }
    std::uint16_t u16(std::size_t at) const {
        return has(at, 2) ? static_cast<std::uint16_t>(m_bytes[at] << 8U | m_bytes[at + 1]) : 0;
    }
    std::int16_t s16(std::size_t at) const { return static_cast<std::int16_t>(u16(at)); }
    std::uint32_t u32(std::size_t at) const {
        return has(at, 4) ? static_cast<std::uint32_t>(u16(at)) << 16U | u16(at + 2) : 0;
    }

private:
    std::span<const std::uint8_t> m_bytes;
};

} // namespace franken
