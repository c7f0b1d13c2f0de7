// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

namespace franken {

/// Reads little-endian numbers from front to back. What lies behind the end reads as 0, and failed() says so.
class ByteReader {
public:
    explicit ByteReader(std::span<const std::uint8_t> bytes, std::size_t at = 0) : m_bytes(bytes), m_at(at) {}

    template<typename Number>
    Number number() {
        using Bits =
            std::conditional_t<sizeof(Number) == 8, std::uint64_t,
                               std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint16_t>>;
        static_assert(sizeof(Number) == sizeof(Bits));
        Bits bits = 0;
        const auto bytes = take(sizeof(Number));
        for (std::size_t i = 0; i < bytes.size(); ++i)
            bits = static_cast<Bits>(bits | static_cast<Bits>(bytes[i]) << 8 * i);
        return std::bit_cast<Number>(bits);
    }

    /// The next `count` bytes; none if there are fewer.
    std::span<const std::uint8_t> take(std::size_t count) {
        m_failed = m_failed || m_at > m_bytes.size() || count > m_bytes.size() - m_at;
        if (m_failed)
            return {};
        m_at += count;
        return m_bytes.subspan(m_at - count, count);
    }

    /// The text up to a zero, which is read too; at most `maxLength` characters.
    std::string_view text(std::size_t maxLength) {
        std::size_t length = 0;
        while (length <= maxLength && m_at + length < m_bytes.size() && m_bytes[m_at + length] != 0)
            ++length;
        m_failed = m_failed || length > maxLength;
        const auto bytes = take(length + 1);
        return bytes.empty() ? std::string_view()
                             : std::string_view(reinterpret_cast<const char*>(bytes.data()), length);
    }

    std::size_t at() const { return m_at; }
    bool failed() const { return m_failed; }

private:
    std::span<const std::uint8_t> m_bytes;
    std::size_t m_at;
    bool m_failed = false;
};

} // namespace franken
