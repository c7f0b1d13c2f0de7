// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace franken::test {

/// What a command left behind.
struct Outcome {
    int code;
    std::string out, err;
};

inline std::string readText(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

/// An empty folder in the build tree for the running test alone: CTest may run several at once.
inline std::filesystem::path emptyTestFolder() {
    const testing::TestInfo& info = *testing::UnitTest::GetInstance()->current_test_info();
    const std::filesystem::path folder = std::filesystem::path(FRANKEN_BINARY_DIR) / "Testing" / "folders" /
                                         (std::string(info.test_suite_name()) + "." + info.name());
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    return folder;
}

/// Runs a command of the shell there, so that a test can redirect and set variables. Leaves "out" and "err".
inline Outcome runIn(const std::filesystem::path& folder, const std::string& command) {
    const std::string line = "cd '" + folder.string() + "' && { " + command + " ; } >out 2>err";
    const int status = std::system(line.c_str());
    return {WEXITSTATUS(status), readText(folder / "out"), readText(folder / "err")};
}

} // namespace franken::test
