// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/result.h"

#include <memory>
#include <string>

namespace franken {
namespace FRANKEN_API platform {

/// The calls of the kernel's CEC that this library makes: what a test puts a fake in place of.
class CecCalls {
public:
    virtual ~CecCalls() = default;
    /// 0 or a negative errno, as ioctl() sets it.
    virtual int call(unsigned long request, void* argument) = 0;
};

/// Switches a television set off and on over HDMI. Optional: many sets obey in part, some not at all; that
/// the picture shows again is proved by the next frame alone.
class Cec {
public:
    /// Fails with `cec.missing` and `cec.permission`.
    static Result<Cec> open(const std::string& device = "/dev/cec0");
    explicit Cec(std::unique_ptr<CecCalls> calls) : m_calls(std::move(calls)) {}

    /// The set goes to sleep (CEC 1.4, <Standby>). Nothing waits: both return when the message is on its way.
    /// Fail with `cec.driver`, and with `cec.no-screen` where nothing is plugged in that says its address.
    Result<void> standby();
    /// The set wakes and shows this machine (<Image View On>, <Active Source>).
    Result<void> wake();

private:
    Result<int> becomePlayer();
    Result<void> send(int from, int to, std::initializer_list<unsigned char> message);

    std::unique_ptr<CecCalls> m_calls;
};

} // namespace platform
} // namespace franken
