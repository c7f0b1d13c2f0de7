// SPDX-License-Identifier: MIT
#pragma once

#include "support/shell.h"

#include <set>

namespace fs = std::filesystem;
using franken::test::Outcome;

inline std::set<std::string> linesOf(const std::string& text) {
    std::set<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        lines.insert(line);
    return lines;
}

/// Runs the real program, in a directory of its own.
class Cli : public testing::Test {
protected:
    fs::path path(const std::string& name) const { return m_directory / name; }
    std::string read(const std::string& name) const { return franken::test::readText(path(name)); }

    Outcome shell(const std::string& command) const { return franken::test::runIn(m_directory, command); }
    Outcome run(const std::string& arguments) const { return shell(kProgram + (" " + arguments)); }

    void writeManifest(const std::string& text) const { std::ofstream(path("warm.txt")) << text; }

    static constexpr const char* kProgram = FRANKEN_BINARY_DIR "/bin/frankenshader";
    const fs::path m_directory = franken::test::emptyTestFolder();
};
