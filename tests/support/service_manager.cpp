// SPDX-License-Identifier: MIT
#include "support/service_manager.h"

#include <gtest/gtest.h>

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstdlib>

namespace franken::test {

// A socket's path has at most 107 characters, which a folder of the build can exceed.
FakeServiceManager::FakeServiceManager(std::chrono::microseconds watchdog)
    : m_path(std::filesystem::temp_directory_path() / ("notify." + std::to_string(getpid()))),
      m_socket(socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {
    sockaddr_un address = {};
    address.sun_family = AF_UNIX;
    EXPECT_LT(m_path.native().size(), sizeof address.sun_path) << "set TMPDIR to a shorter path";
    std::snprintf(address.sun_path, sizeof address.sun_path, "%s", m_path.c_str());
    EXPECT_EQ(bind(m_socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    setenv("NOTIFY_SOCKET", m_path.c_str(), 1);
    setenv("WATCHDOG_USEC", std::to_string(watchdog.count()).c_str(), 1);
}

FakeServiceManager::~FakeServiceManager() {
    close(m_socket);
    std::filesystem::remove(m_path);
    unsetenv("NOTIFY_SOCKET");
    unsetenv("WATCHDOG_USEC");
}

std::string FakeServiceManager::next() const {
    char text[256];
    const ssize_t bytes = recv(m_socket, text, sizeof text, 0);
    return bytes > 0 ? std::string(text, static_cast<std::size_t>(bytes)) : std::string();
}

} // namespace franken::test
