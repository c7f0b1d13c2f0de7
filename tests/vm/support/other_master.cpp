// SPDX-License-Identifier: MIT
#include "support/other_master.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <xf86drm.h>

#include <csignal>

namespace franken::test {

OtherMaster::OtherMaster() {
    [[maybe_unused]] const int made = pipe(m_pipe);
    m_process = fork();
    if (m_process == 0) {
        const int device = open("/dev/dri/card0", O_RDWR);
        const char result = drmSetMaster(device) == 0 ? 'y' : 'n';
        [[maybe_unused]] const ssize_t written = write(m_pipe[1], &result, 1);
        pause();
    }
    char result = 'n';
    EXPECT_TRUE(read(m_pipe[0], &result, 1) == 1 && result == 'y') << "the screen has a master already";
}

OtherMaster::~OtherMaster() {
    kill(m_process, SIGKILL);
    waitpid(m_process, nullptr, 0);
    close(m_pipe[0]);
    close(m_pipe[1]);
}

} // namespace franken::test
