// SPDX-License-Identifier: MIT
#pragma once

namespace franken::cli {

/// What the shell sees. Part of the interface: documented in the man page.
enum class ExitCode : int {
    Ok = 0,
    Failed = 1,  ///< A check found something, or two programs differ.
    Usage = 2,   ///< The command line makes no sense.
    Refused = 3, ///< A name, a filter or a file was refused.
    Device = 4,  ///< A file could not be written, or a tool could not be run.
};

} // namespace franken::cli
