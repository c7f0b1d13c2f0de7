// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"

#include <cstddef>
#include <string_view>

namespace FRANKEN_API franken {

/// What decodeUtf8() read.
struct CodePoint {
    char32_t code = 0;     ///< 0 where `bytes` is 0.
    std::size_t bytes = 0; ///< 0 where the text does not begin with valid UTF-8.
};

/// The first code point of a text that is not empty (RFC 3629: no overlong forms, no surrogates).
CodePoint decodeUtf8(std::string_view text);

/// Whether nothing is seen of it: control characters, line ends, and what Unicode calls default-ignorable
/// (marks of direction, joiners, fillers, variation selectors, tags).
bool isUnseen(char32_t code);

} // namespace franken
