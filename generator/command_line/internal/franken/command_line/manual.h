// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <string_view>
#include <vector>

/// Manual pages and completions for shells, made from a program's table of options, so that they cannot lag
/// behind it. All programs use them; frankenshader has a page of its own that is filled in, and completes the
/// words of names as well.
namespace franken::cli {

/// The shells that completions are made for.
inline const std::vector<std::string> kShells = {"bash", "zsh", "fish"};

/// Adds --manual and --completions SHELL, which print for the program under the name that it is installed by.
/// A footer's lines that begin with "Exit codes:" and "Example:" become sections of their own.
void addManual(CLI::App& app, const std::string& installedName);

/// A whole page: NAME, SYNOPSIS, DESCRIPTION, OPTIONS, COMMANDS, EXIT STATUS and EXAMPLES, as far as there
/// are any.
std::string manPageOf(const CLI::App& app, const std::string& installedName);

/// A page in roff of a program with commands, whose lines @SYNOPSIS@ and @OPTIONS@ are replaced: by a line a
/// command, and by a subsection a command with all that it takes.
std::string filledManPage(const CLI::App& app, const std::string& page);

/// The commands of a program that its help shows.
std::vector<const CLI::App*> shownCommands(const CLI::App& app);

/// A script by which a shell completes options, commands, and files.
std::string completionsOf(const CLI::App& app, const std::string& installedName, std::string_view shell);

/// In a shell's single quotes; zsh wants `colons` escaped, which separate its descriptions.
std::string quoted(std::string_view text, bool colons);

} // namespace franken::cli
