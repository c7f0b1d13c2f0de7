// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/result.h"

#include <string>
#include <string_view>

namespace FRANKEN_API franken {

/// Text from outside (a file, its name, an argument) as a terminal can show it without being steered by it:
/// control characters, those that turn the direction of writing or are invisible, and bytes that are no UTF-8
/// become escapes (\n, \t, \x1b, \u{202e}). All else stays as it is.
std::string printable(std::string_view text);

/// The same, but line ends and tabs stay: for whole files.
std::string printableLines(std::string_view text);

/// The same, for a message: lines from the second on are indented, so that a name with a line end in it looks
/// like no message of its own.
std::string printableMessage(std::string_view text);

/// toString(error) for a terminal: `what` is a message, all else has one line.
std::string printable(const Error& error);

/// UTF-8 saved by a Windows editor may begin with U+FEFF, which is not part of the text.
inline std::string_view withoutByteOrderMark(std::string_view text) {
    constexpr std::string_view kMark = "\xEF\xBB\xBF";
    return text.starts_with(kMark) ? text.substr(kMark.size()) : text;
}

} // namespace franken
