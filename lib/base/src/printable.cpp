// SPDX-License-Identifier: MIT
#include "franken/printable.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>

namespace franken {
namespace {

struct Decoded {
    char32_t code = 0;
    std::size_t bytes = 0; ///< 0 where there is no valid sequence.
};

/// One code point of UTF-8 (RFC 3629: no overlong forms, no surrogates).
Decoded decode(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
    const std::uint8_t lead = byte(0);
    if (lead < 0x80)
        return {lead, 1};
    const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || text.size() < length)
        return {};
    char32_t code = lead & (0xFFU >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0U) != 0x80U)
            return {};
        code = code << 6U | (byte(i) & 0x3FU);
    }
    constexpr char32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    return code < kLeast[length] || surrogate || code > 0x10FFFF ? Decoded{} : Decoded{code, length};
}

struct Range {
    char32_t first, last;
};

// Unicode's categories Cc, Cf, Zl and Zp, as far as terminals and editors heed them; the tags of plane 14.
constexpr Range kUnseen[] = {{0, 0x1F},        {0x7F, 0x9F},     {0xAD, 0xAD},      {0x61C, 0x61C},
                             {0x180E, 0x180E}, {0x200B, 0x200F}, {0x2028, 0x202E},  {0x2060, 0x206F},
                             {0xFEFF, 0xFEFF}, {0xFFF9, 0xFFFB}, {0xE0000, 0xE007F}};

bool isUnseen(char32_t code) {
    return std::any_of(std::begin(kUnseen), std::end(kUnseen),
                       [code](Range range) { return code >= range.first && code <= range.last; });
}

std::string escaped(char32_t code) {
    switch (code) {
    case '\n':
        return "\\n";
    case '\r':
        return "\\r";
    case '\t':
        return "\\t";
    default:
        char text[16];
        std::snprintf(text, sizeof text, code < 0x80 ? "\\x%02x" : "\\u{%04x}", static_cast<unsigned>(code));
        return text;
    }
}

std::string shown(std::string_view text, std::string_view kept) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const Decoded next = decode(text);
        if (next.bytes == 0) {
            char byte[8];
            std::snprintf(byte, sizeof byte, "\\x%02x", static_cast<std::uint8_t>(text.front()));
            result += byte;
        } else if (isUnseen(next.code) && kept.find(text.front()) == std::string_view::npos) {
            result += escaped(next.code);
        } else {
            result += text.substr(0, next.bytes);
        }
        text.remove_prefix(std::max<std::size_t>(next.bytes, 1));
    }
    return result;
}

} // namespace

std::string printable(std::string_view text) { return shown(text, ""); }

std::string printableLines(std::string_view text) { return shown(text, "\n\t"); }

} // namespace franken
