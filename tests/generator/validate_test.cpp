// SPDX-License-Identifier: MIT
// Every permutation of the population composes, and passes the project's own lint and glslang.
#include "franken/generator/compose.h"
#include "franken/generator/lint.h"
#include "population.h"
#include "support/shell.h"

#include <iostream>
#include <set>

namespace franken {
namespace {

using namespace test;
namespace fs = std::filesystem;

constexpr std::size_t kFilesPerProcess = 400;

TEST(Validate, EveryPermutationPassesTheLint) {
    std::set<std::string> seen;
    for (const Permutation& p : population())
        for (const LintFinding& finding : lintProgram(compose(p)))
            if (const std::string text = toString(finding); seen.insert(text).second) {
                ADD_FAILURE() << text << " in " << toName(p);
            }
    std::cout << population().size() << " permutations: composed, linted\n";
}

// glslang's messages, without the names that it prints for files without a fault.
std::string messagesIn(const std::string& output) {
    std::istringstream lines(output);
    std::string messages;
    for (std::string line; std::getline(lines, line);)
        if (line.find("ERROR") != std::string::npos || line.find("WARNING") != std::string::npos)
            messages += line + '\n';
    return messages;
}

// Writes each stage that is not there yet; files are called after their stage keys.
std::set<std::string> writeShaders(const fs::path& folder) {
    std::set<std::string> files;
    for (const Permutation& p : population()) {
        const Composed program = compose(p);
        const std::string vertex = toHex(stageKey(p, Stage::Vertex)) + ".vert";
        const std::string fragment = toHex(stageKey(p, Stage::Fragment)) + ".frag";
        if (files.insert(vertex).second)
            std::ofstream(folder / vertex) << program.vertex.text;
        if (files.insert(fragment).second)
            std::ofstream(folder / fragment) << program.fragment.text;
    }
    return files;
}

TEST(Validate, EveryPermutationPassesGlslang) {
    const fs::path folder = emptyTestFolder();
    if (runIn(folder, "glslangValidator --version").code != 0)
        GTEST_SKIP() << "glslangValidator is not installed (Debian: glslang-tools)";
    const std::set<std::string> files = writeShaders(folder);
    for (auto file = files.begin(); file != files.end();) {
        std::string command = "glslangValidator";
        for (std::size_t size = 0; size < kFilesPerProcess && file != files.end(); ++size, ++file)
            command += " " + *file;
        const Outcome outcome = runIn(folder, command);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_EQ(messagesIn(outcome.out), "");
    }
    std::cout << population().size() << " permutations (" << files.size()
              << " shaders): composed, linted, glslang\n";
}

// A validator that accepts everything would pass, too.
TEST(Validate, GlslangRefusesWhatIsNoShader) {
    const fs::path folder = emptyTestFolder();
    if (runIn(folder, "glslangValidator --version").code != 0)
        GTEST_SKIP() << "glslangValidator is not installed (Debian: glslang-tools)";
    std::ofstream(folder / "good.vert") << compose({}).vertex.text;
    std::ofstream(folder / "bad.vert")
        << "#version 100\nvoid main() { gl_Position = vec4(1); int x = 1.0; }\n";
    const Outcome outcome = runIn(folder, "glslangValidator bad.vert good.vert");
    EXPECT_NE(outcome.code, 0);
    EXPECT_NE(messagesIn(outcome.out), "");
}

} // namespace
} // namespace franken
