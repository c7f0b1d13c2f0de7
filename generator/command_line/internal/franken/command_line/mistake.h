// SPDX-License-Identifier: MIT
#pragma once

#include "franken/result.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace franken::cli {

/// What is wrong with a command line that the parser refused, with the nearest command or option where one is
/// unknown. An unknown one is reported before what is missing because of it. The code is "usage". Arguments
/// are quoted as they were typed: whoever shows the error calls printable().
Error mistakeIn(const CLI::App& app, const CLI::ParseError& refusal);

/// The names of the commands, in the order of the help; empty for a program without.
std::vector<std::string> commandsOf(const CLI::App& app);

/// The word of these that was probably meant, or nothing.
std::string nearestOf(const std::string& word, const std::vector<std::string>& words);

/// Takes one of these words; offers the nearest for any other.
CLI::Validator oneOf(const std::vector<std::string>& words);

/// Refuses an empty text, which a script passes whose variable has no value.
CLI::Validator notEmpty();

/// Takes a whole number from `least` to `most`, and no sign but that of a number below 0.
CLI::Validator wholeNumber(long long least, long long most);

} // namespace franken::cli
