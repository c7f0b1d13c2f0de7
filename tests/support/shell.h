// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

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

/// A folder in the build tree for this process alone: CTest may run several tests at once, and someone else
/// the same ones. Removed at the end where all went well.
class RunFolder {
public:
    static const std::filesystem::path& path() {
        static const RunFolder folder;
        return folder.m_path;
    }
    ~RunFolder() {
        std::error_code ignored;
        if (getpid() == m_process && testing::UnitTest::GetInstance()->Passed())
            std::filesystem::remove_all(m_path, ignored);
    }
    RunFolder(const RunFolder&) = delete;
    RunFolder& operator=(const RunFolder&) = delete;

private:
    RunFolder() = default;

    pid_t m_process = getpid(); // A child that a test made and that ends leaves it alone.
    std::filesystem::path m_path =
        std::filesystem::path(FRANKEN_BINARY_DIR) / "Testing" / "folders" / std::to_string(m_process);
};

/// A folder for the running test alone.
inline std::filesystem::path testFolder() {
    const testing::TestInfo& info = *testing::UnitTest::GetInstance()->current_test_info();
    const std::filesystem::path folder =
        RunFolder::path() / (std::string(info.test_suite_name()) + "." + info.name());
    std::filesystem::create_directories(folder);
    return folder;
}

/// The same, without what an earlier run left in it.
inline std::filesystem::path emptyTestFolder() {
    std::filesystem::remove_all(testFolder());
    return testFolder();
}

/// Runs a command of the shell there, so that a test can redirect and set variables. Leaves "out" and "err".
inline Outcome runIn(const std::filesystem::path& folder, const std::string& command) {
    const std::string line = "cd '" + folder.string() + "' && { " + command + " ; } >out 2>err";
    const int status = std::system(line.c_str());
    return {WEXITSTATUS(status), readText(folder / "out"), readText(folder / "err")};
}

/// The most memory that a program had, run there as the shell's own process, in KiB; a failure where it
/// fails. Not less than this process has.
inline long peakKiBIn(const std::filesystem::path& folder, const std::string& command) {
    const std::string line = "cd '" + folder.string() + "' && exec " + command + " >out 2>err";
    const pid_t child = fork();
    if (child == 0) {
        execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
        _exit(127);
    }
    int status = 0;
    rusage usage{};
    EXPECT_EQ(wait4(child, &status, 0, &usage), child);
    EXPECT_EQ(status, 0) << readText(folder / "err");
    return usage.ru_maxrss;
}

} // namespace franken::test
