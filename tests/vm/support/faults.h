// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace franken::test {

/// The calls of libdrm, GBM and EGL by which the platform takes a screen, in the order of a start.
enum class Call {
    SetClientCap,
    GetResources,
    CreateGbmDevice,
    GetDisplay,
    Initialize,
    CreateContext,
    CreateBuffer,
    AddFramebuffer,
    CreateBlob,
    TestCommit, ///< An atomic commit that asks only.
    CreateSurface,
    CreateWindow,
    MakeCurrent,
    SwapBuffers,
    LockBuffer,
    Commit, ///< One that does something.
};
inline constexpr int kCalls = static_cast<int>(Call::Commit) + 1;
const char* toString(Call call);

/// Answers that mean "let it through" and "say that it was done, and do nothing".
inline constexpr int kPass = 0, kLose = 1;

/// Asked before each of these calls of this program; empty: all are let through. It returns kPass, kLose, or
/// a negative errno to fail with. Only a program that is linked with this file has its calls asked about.
extern std::function<int(Call)> onCall;

} // namespace franken::test
