// SPDX-License-Identifier: MIT
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <string>

namespace franken::test {

/// An X server without a screen, for as long as the object lives; it chooses a display that is free.
class XServer {
public:
    /// Its picture is kept in the file Xvfb_screen0 of that folder, as an X window dump.
    explicit XServer(const std::string& folder) {
        std::array<int, 2> pipe{};
        if (::pipe(pipe.data()) != 0)
            return;
        m_process = fork();
        if (m_process == 0) {
            close(pipe[0]);
            execlp("Xvfb", "Xvfb", "-displayfd", std::to_string(pipe[1]).c_str(), "-screen", "0",
                   "640x480x24", "-nolisten", "tcp", "-fbdir", folder.c_str(), static_cast<char*>(nullptr));
            _exit(127);
        }
        close(pipe[1]);
        for (char digit = 0; read(pipe[0], &digit, 1) == 1 && digit != '\n';)
            m_number += digit;
        close(pipe[0]);
    }
    ~XServer() {
        if (m_process <= 0)
            return;
        kill(m_process, SIGTERM);
        waitpid(m_process, nullptr, 0);
    }
    XServer(const XServer&) = delete;
    XServer& operator=(const XServer&) = delete;

    /// ":3"; empty where Xvfb does not start.
    std::string display() const { return m_number.empty() ? "" : ":" + m_number; }

private:
    pid_t m_process = -1;
    std::string m_number;
};

} // namespace franken::test
