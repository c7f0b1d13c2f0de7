// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

namespace franken::test {

/// A process that is the screen's master for as long as this lives; the test fails where it cannot be.
class OtherMaster {
public:
    OtherMaster();
    ~OtherMaster();
    OtherMaster(const OtherMaster&) = delete;
    OtherMaster& operator=(const OtherMaster&) = delete;

private:
    int m_pipe[2] = {-1, -1};
    pid_t m_process;
};

} // namespace franken::test
