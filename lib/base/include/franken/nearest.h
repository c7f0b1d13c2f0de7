// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"

#include <span>
#include <string_view>

namespace FRANKEN_API franken {

/// The word that was probably meant: the nearest by edit distance, a swap of neighbours counting as one; of
/// words that end in a number (sun1 to sun4) the one with the nearest number. Empty where none is near: more
/// than two edits in five characters are another word, not a slip of a finger.
std::string_view nearestWord(std::string_view text, std::span<const std::string_view> words);

} // namespace franken
