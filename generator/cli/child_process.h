// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace franken::cli {

/// The files that a program reads and writes in place of ours.
struct Streams {
    std::filesystem::path in = {}; ///< Empty: our own standard input.
    std::filesystem::path out = {};
    std::filesystem::path err = {}; ///< Empty: where `out` goes.
};

/// What a program came to that was run.
struct Outcome {
    int spawnError = 0; ///< The errno where it could not be started; 0 where it ran.
    int exitCode = 0;   ///< 128 + N where signal N ended it.
};

/// Runs arguments[0], which is looked for in PATH where it has no slash, and waits for its end.
Outcome runProgram(std::vector<std::string> arguments, const Streams& streams);

} // namespace franken::cli
