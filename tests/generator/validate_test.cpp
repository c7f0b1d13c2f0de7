// SPDX-License-Identifier: MIT
// Every permutation of the population composes, and passes the project's own lint and glslang.
#include "franken/generator/compose.h"
#include "franken/generator/lint.h"
#include "population.h"

#include <gtest/gtest.h>

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
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

struct Outcome {
    int status;
    std::string output;
};

Outcome run(const std::string& command) {
    FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    Outcome outcome{-1, {}};
    std::array<char, 4096> buffer{};
    while (pipe && std::fgets(buffer.data(), buffer.size(), pipe))
        outcome.output += buffer.data();
    if (pipe)
        outcome.status = WEXITSTATUS(pclose(pipe));
    return outcome;
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
    fs::remove_all(folder);
    fs::create_directories(folder);
    std::set<std::string> files;
    for (const Permutation& p : population()) {
        const Composed program = compose(p);
        const std::string vertex = std::to_string(stageKey(p, Stage::Vertex)) + ".vert";
        const std::string fragment = std::to_string(stageKey(p, Stage::Fragment)) + ".frag";
        if (files.insert(vertex).second)
            std::ofstream(folder / vertex) << program.vertex.text;
        if (files.insert(fragment).second)
            std::ofstream(folder / fragment) << program.fragment.text;
    }
    return files;
}

TEST(Validate, EveryPermutationPassesGlslang) {
    if (run("glslangValidator --version").status != 0)
        GTEST_SKIP() << "glslangValidator is not installed (Debian: glslang-tools)";
    const fs::path folder = FRANKEN_BINARY_DIR "/glslang";
    const std::set<std::string> files = writeShaders(folder);
    for (auto file = files.begin(); file != files.end();) {
        std::string command = "cd '" + folder.string() + "' && glslangValidator";
        for (std::size_t size = 0; size < kFilesPerProcess && file != files.end(); ++size, ++file)
            command += " " + *file;
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.status, 0);
        EXPECT_EQ(messagesIn(outcome.output), "");
    }
    std::cout << population().size() << " permutations (" << files.size()
              << " shaders): composed, linted, glslang\n";
}

// A validator that accepts everything would pass, too.
TEST(Validate, GlslangRefusesWhatIsNoShader) {
    if (run("glslangValidator --version").status != 0)
        GTEST_SKIP() << "glslangValidator is not installed (Debian: glslang-tools)";
    const fs::path folder = FRANKEN_BINARY_DIR "/glslang-refused";
    fs::create_directories(folder);
    std::ofstream(folder / "good.vert") << compose({}).vertex.text;
    std::ofstream(folder / "bad.vert")
        << "#version 100\nvoid main() { gl_Position = vec4(1); int x = 1.0; }\n";
    const Outcome outcome = run("cd '" + folder.string() + "' && glslangValidator bad.vert good.vert");
    EXPECT_NE(outcome.status, 0);
    EXPECT_NE(messagesIn(outcome.output), "");
}

} // namespace
} // namespace franken
