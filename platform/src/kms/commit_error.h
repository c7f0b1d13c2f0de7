// SPDX-License-Identifier: MIT
#pragma once

namespace franken::platform {

/// What to do about a commit that the kernel refused.
enum class CommitAction {
    Retry,         ///< In a moment, later and later; then switch the screen off and on; then give up.
    StepDown,      ///< This format or mode cannot be shown: try the next one.
    WaitForMaster, ///< Somebody else has the screen.
    WaitForDevice  ///< The device is gone.
};

/// `error` is a negative errno.
CommitAction actionFor(int error);

} // namespace franken::platform
