// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace fs = std::filesystem;

inline std::string read(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

inline std::set<std::string> linesOf(const std::string& text) {
    std::set<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        lines.insert(line);
    return lines;
}

/// What a command left behind.
struct Outcome {
    int code;
    std::string out, err;
};

/// Runs the real program, in a directory of its own.
class Cli : public testing::Test {
protected:
    void SetUp() override {
        std::string pattern = (fs::temp_directory_path() / "cli_test.XXXXXX").string();
        ASSERT_TRUE(mkdtemp(pattern.data()));
        m_directory = pattern;
    }
    void TearDown() override { fs::remove_all(m_directory); }

    fs::path path(const std::string& name) const { return m_directory / name; }

    // In a shell, so that a test can redirect and set variables.
    Outcome shell(const std::string& command) const {
        const std::string line = "cd '" + m_directory.string() + "' && { " + command + " ; } >out 2>err";
        const int status = std::system(line.c_str());
        return {WEXITSTATUS(status), read(path("out")), read(path("err"))};
    }
    Outcome run(const std::string& arguments) const { return shell(kProgram + (" " + arguments)); }

    void writeManifest(const std::string& text) const { std::ofstream(path("warm.txt")) << text; }

    static constexpr const char* kProgram = FRANKEN_BINARY_DIR "/bin/frankenshader";
    fs::path m_directory;
};
