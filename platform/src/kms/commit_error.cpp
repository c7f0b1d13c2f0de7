// SPDX-License-Identifier: MIT
#include "commit_error.h"

#include <cerrno>

namespace franken::platform {

CommitAction actionFor(int error) {
    switch (-error) {
    case EINVAL:
    case ERANGE:
    case EOPNOTSUPP:
        return CommitAction::StepDown;
    case EACCES:
    case EPERM:
        return CommitAction::WaitForMaster;
    case ENODEV:
    case ENXIO:
        return CommitAction::WaitForDevice;
    default:
        return CommitAction::Retry; // EBUSY, ENOSPC, ENOMEM, and whatever a driver comes up with.
    }
}

} // namespace franken::platform
