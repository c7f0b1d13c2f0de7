// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

namespace franken::test {

/// A service manager's end of sd_notify: the environment names it for as long as it lives.
class FakeServiceManager {
public:
    explicit FakeServiceManager(std::chrono::microseconds watchdog);
    ~FakeServiceManager();
    FakeServiceManager(const FakeServiceManager&) = delete;
    FakeServiceManager& operator=(const FakeServiceManager&) = delete;

    int descriptor() const { return m_socket; }
    /// One message; empty where none has come.
    std::string next() const;

private:
    std::filesystem::path m_path;
    int m_socket;
};

} // namespace franken::test
