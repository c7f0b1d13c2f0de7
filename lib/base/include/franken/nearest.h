// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"

#include <span>
#include <string_view>

namespace FRANKEN_API franken {

/// The word that was probably meant: the nearest by edit distance, where swapping neighbours counts as one
/// edit and a letter's case as none; of words that end in a number (sun1 to sun4), the word with the nearest
/// number. Empty where no word is near: with more than two edits in five characters it is another word, not a
/// slip of a finger.
std::string_view nearestWord(std::string_view text, std::span<const std::string_view> words);

} // namespace franken
