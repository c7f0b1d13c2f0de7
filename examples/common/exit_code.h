// SPDX-License-Identifier: MIT
#pragma once

/// What the shell sees.
enum class ExitCode : int {
    Ok = 0,
    Unhealthy = 1, ///< `kiosk doctor` found something to mend.
    Usage = 2,   ///< The command line makes no sense.
    Refused = 3, ///< A file was refused.
    Device = 4,  ///< No context, a program that does not compile, or a picture that cannot be written.
};
