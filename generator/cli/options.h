// SPDX-License-Identifier: MIT
#pragma once

#include "console.h"
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
    std::vector<std::string> names; ///< Or keys, "0x...".
    bool covering = false;
    std::string manifest; ///< A file, "-" for standard input; empty for none.
    std::vector<std::string> with, without, where;
    std::optional<std::size_t> limit; ///< 0 for none.
    Shard shard;
    bool fits = false;                 ///< Only what fits in each of the profiles.
    std::vector<std::string> profiles; ///< By name, or "all".

    bool filtered() const { return !with.empty() || !without.empty() || !where.empty(); }
    bool empty() const { return names.empty() && !covering && manifest.empty() && !filtered(); }
};

struct ListOptions {
    SelectionOptions selection;
    bool count = false;
    bool words = false;
    bool json = false;
};

/// What `dump` writes.
enum class DumpFormat : std::uint8_t {
    Text,  ///< One program's stages.
    Files, ///< A folder with a file a stage, and a manifest.json.
    Json,  ///< One document.
    C,     ///< One header.
};

struct DumpOptions {
    SelectionOptions selection;
    std::optional<DumpFormat> format; ///< Else Files where there is an output, Text where there is none.
    std::string output;               ///< A folder for Files, a file for others; empty: standard output.
    std::string depfile;              ///< Empty for none.
    std::optional<Stage> stage;

    DumpFormat chosen() const {
        return format.value_or(output.empty() ? DumpFormat::Text : DumpFormat::Files);
    }
};

struct ExplainOptions {
    std::string name;
    bool json = false;
};

struct DiffOptions {
    std::vector<std::string> names; ///< Two, where nothing is named in `against`.
    std::string against;            ///< A folder that `dump -o` wrote; empty for none.
    bool json = false;
};

struct CheckOptions {
    SelectionOptions selection;
    bool json = false;
};

/// The most instructions that a fragment shader may have on a GPU.
struct CostLimit {
    std::string gpu;
    int instructions = 0;
};

struct CostOptions {
    SelectionOptions selection;
    std::vector<std::string> gpus; ///< By name; none is all.
    std::vector<CostLimit> limits;
    std::string baseline; ///< A file that `cost --json` wrote; empty for none.
    bool json = false;

    bool isGate() const { return !limits.empty() || !baseline.empty(); }
};

/// A parsed command line, or the exit code where there is nothing left to do: help, the version,
/// completions, or a mistake that has been reported.
using Command =
    std::variant<ExitCode, ListOptions, DumpOptions, ExplainOptions, DiffOptions, CheckOptions, CostOptions>;

Command parseCommandLine(int argc, const char* const* argv, Console& console);

} // namespace franken::cli
