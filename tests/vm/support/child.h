// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace franken::test {

/// A program that runs beside the test. It is killed with it.
class Child {
public:
    /// The program's path and its arguments. `output`: a file that gets what it prints; empty: as the test.
    explicit Child(const std::vector<std::string>& command, const std::string& output = {});
    ~Child();
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    pid_t process() const { return m_process; }
    void signal(int number) const;
    bool runs();
    /// Waits for its end: the exit code, or 128 and the signal that ended it.
    int wait();

private:
    pid_t m_process;
    std::optional<int> m_code;
};

} // namespace franken::test
