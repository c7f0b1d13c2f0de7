// SPDX-License-Identifier: MIT
#include "child_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <sstream>

namespace franken::cli {
namespace {

class FileActions {
public:
    explicit FileActions(const Streams& streams) {
        constexpr int kWrite = O_WRONLY | O_CREAT | O_TRUNC;
        posix_spawn_file_actions_init(&m_actions);
        if (!streams.in.empty())
            open(STDIN_FILENO, streams.in, O_RDONLY);
        open(STDOUT_FILENO, streams.out, kWrite);
        if (streams.err.empty())
            posix_spawn_file_actions_adddup2(&m_actions, STDOUT_FILENO, STDERR_FILENO);
        else
            open(STDERR_FILENO, streams.err, kWrite);
    }
    ~FileActions() { posix_spawn_file_actions_destroy(&m_actions); }
    FileActions(const FileActions&) = delete;
    FileActions& operator=(const FileActions&) = delete;

    const posix_spawn_file_actions_t* get() const { return &m_actions; }

private:
    void open(int descriptor, const std::filesystem::path& file, int flags) {
        posix_spawn_file_actions_addopen(&m_actions, descriptor, file.c_str(), flags, 0600);
    }

    posix_spawn_file_actions_t m_actions;
};

bool isInPath(const std::string& program) {
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "");
    std::error_code unreadable;
    for (std::string folder; std::getline(folders, folder, ':');)
        if (std::filesystem::is_regular_file(std::filesystem::path(folder) / program, unreadable))
            return true;
    return false;
}

/// Where a name has no slash, EACCES can also mean that a folder of PATH may not be searched. If no other
/// folder has the program, it is not installed.
int spawnErrorOf(int error, const std::string& program) {
    const bool isNowhere = error == EACCES && program.find('/') == std::string::npos && !isInPath(program);
    return isNowhere ? ENOENT : error;
}

} // namespace

Outcome runProgram(std::vector<std::string> arguments, const Streams& streams) {
    std::vector<char*> argv;
    argv.reserve(arguments.size() + 1);
    for (std::string& argument : arguments)
        argv.push_back(argument.data());
    argv.push_back(nullptr);
    const FileActions actions(streams);
    pid_t child = 0;
    if (const int failed = posix_spawnp(&child, argv[0], actions.get(), nullptr, argv.data(), environ);
        failed != 0)
        return {spawnErrorOf(failed, arguments[0]), 0};
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return {0, WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status)};
}

} // namespace franken::cli
