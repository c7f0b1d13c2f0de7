// SPDX-License-Identifier: MIT
#pragma once

#include "console.h"
#include "options.h"

namespace franken::cli {

// One function a command, each in a file of its name. Data goes to standard output, whatever else there is
// to say to standard error.

ExitCode run(const ListOptions& options, Console& console);
ExitCode run(const DumpOptions& options, Console& console);
ExitCode run(const ExplainOptions& options, Console& console);
ExitCode run(const DiffOptions& options, Console& console);
ExitCode run(const CheckOptions& options, Console& console);
ExitCode run(const CostOptions& options, Console& console);

/// A command line that has been answered already.
inline ExitCode run(ExitCode code, Console&) { return code; }

} // namespace franken::cli
