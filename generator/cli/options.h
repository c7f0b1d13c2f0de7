// SPDX-License-Identifier: MIT
#pragma once

#include "exit_code.h"
#include "franken/generator/permutation.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace franken::cli {

/// Part `index` of `count`, from 1: every count-th permutation.
struct Shard {
    std::size_t index = 1, count = 1;
};

/// Which permutations a command is about. At most one of names, covering and manifest is given; without
/// them it is the whole space, simplest first. The filters apply to all.
struct SelectionOptions {
    std::vector<std::string> names;
    bool covering = false;
    std::string manifest; ///< A file, "-" for standard input; empty for none.
    std::vector<std::string> with, without, where;
    std::optional<std::size_t> limit; ///< 0 for none.
    Shard shard;

    bool filtered() const { return !with.empty() || !without.empty() || !where.empty(); }
    bool empty() const { return names.empty() && !covering && manifest.empty() && !filtered(); }
};

struct ListOptions {
    SelectionOptions selection;
    bool count = false;
    bool words = false;
    bool json = false;
};

struct DumpOptions {
    SelectionOptions selection;
    std::string directory; ///< Empty: one program to standard output.
    std::optional<Stage> stage;
    bool json = false;
};

struct ExplainOptions {
    std::string name;
    bool json = false;
};

struct DiffOptions {
    std::string first, second;
    bool json = false;
};

struct CheckOptions {
    SelectionOptions selection;
    std::vector<std::string> profiles; ///< By name, or "all".
    bool json = false;
};

struct CostOptions {
    SelectionOptions selection;
    std::vector<std::string> gpus; ///< By name; none is all.
    bool json = false;
};

/// A parsed command line, or the exit code where there is nothing left to do: --help, --version, or a
/// mistake that has been reported.
using Command =
    std::variant<ExitCode, ListOptions, DumpOptions, ExplainOptions, DiffOptions, CheckOptions, CostOptions>;

Command parseCommandLine(int argc, const char* const* argv);

} // namespace franken::cli
