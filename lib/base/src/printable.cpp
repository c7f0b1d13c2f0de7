// SPDX-License-Identifier: MIT
#include "franken/printable.h"

#include "franken/utf8.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>

namespace franken {
namespace {

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
        const CodePoint next = decodeUtf8(text);
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

std::string printableMessage(std::string_view text) {
    std::string message;
    for (const char c : printableLines(text)) {
        if (!message.empty() && message.back() == '\n' && c != ' ' && c != '\n')
            message += "  ";
        message += c;
    }
    return message;
}

std::string printable(const Error& error) {
    return toString(
        {error.code, printable(error.where), printableMessage(error.what), printable(error.remedy)});
}

} // namespace franken
