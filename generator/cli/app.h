// SPDX-License-Identifier: MIT
#pragma once

#include "franken/command_line/manual.h"
#include "options.h"

#include <CLI/CLI.hpp>

namespace franken::cli {

/// All that a command line can say: the table of commands and options that the parser, the help, the
/// suggestions and the completions are made from.
struct App {
    App();
    App(const App&) = delete;
    App& operator=(const App&) = delete;

    CLI::App app;
    ListOptions list;
    DumpOptions dump;
    ExplainOptions explain;
    DiffOptions diff;
    CheckOptions check;
    CostOptions cost;
    std::vector<std::string> effects; ///< Files and folders, for any of them.
    std::string helpTopic;            ///< Of `help`; empty for all.
    std::string shell;                ///< Of `completions`.
    std::string page;                 ///< Of `manual`: a file.
};

/// A script for that shell.
std::string completionsFor(const CLI::App& app, std::string_view shell);

} // namespace franken::cli
