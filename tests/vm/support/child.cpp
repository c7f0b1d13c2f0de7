// SPDX-License-Identifier: MIT
#include "support/child.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace franken::test {

namespace {

int codeOf(int status) { return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status); }

[[noreturn]] void become(const std::vector<std::string>& command, const std::string& output) {
    if (!output.empty()) {
        const int file = open(output.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
        dup2(file, STDOUT_FILENO);
        dup2(file, STDERR_FILENO);
    }
    std::vector<char*> arguments;
    for (const std::string& argument : command)
        arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    execv(arguments.front(), arguments.data());
    _exit(127);
}

} // namespace

Child::Child(const std::vector<std::string>& command, const std::string& output) : m_process(fork()) {
    if (m_process == 0)
        become(command, output);
}

Child::~Child() {
    signal(SIGKILL);
    wait();
}

void Child::signal(int number) const {
    if (!m_code)
        kill(m_process, number);
}

bool Child::runs() {
    int status = 0;
    if (!m_code && waitpid(m_process, &status, WNOHANG) == m_process)
        m_code = codeOf(status);
    return !m_code;
}

int Child::wait() {
    int status = 0;
    if (!m_code && waitpid(m_process, &status, 0) == m_process)
        m_code = codeOf(status);
    return m_code.value_or(-1);
}

} // namespace franken::test
