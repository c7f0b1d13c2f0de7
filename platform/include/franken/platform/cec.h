// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/result.h"

#include <memory>
#include <string>

namespace franken {
namespace FRANKEN_API platform {

/// The calls to the kernel's CEC device; tests replace them by a fake.
class CecCalls {
public:
    virtual ~CecCalls() = default;
    /// 0 or a negative errno, as ioctl() sets it.
    virtual int call(unsigned long request, void* argument) = 0;
};

/// Switches a television set off and on over HDMI. Do not rely on it: many sets obey in part, some not at
/// all, and only the next completed frame proves that the picture shows again.
class Cec {
public:
    /// Fails with `cec.missing` and `cec.permission`.
    static Result<Cec> open(const std::string& device = "/dev/cec0");
    explicit Cec(std::unique_ptr<CecCalls> calls) : m_calls(std::move(calls)) {}

    /// Sends the set to sleep (CEC 1.4, <Standby>). standby() and wake() do not wait for an answer. Both fail
    /// with `cec.driver`, and with `cec.no-screen` where no connected screen reports its address.
    Result<void> standby();
    /// Wakes the set and makes it show this machine (<Image View On>, <Active Source>).
    Result<void> wake();

private:
    Result<int> becomePlayer();
    Result<void> send(int from, int to, std::initializer_list<unsigned char> message);

    std::unique_ptr<CecCalls> m_calls;
};

} // namespace platform
} // namespace franken
