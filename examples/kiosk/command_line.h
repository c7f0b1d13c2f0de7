// SPDX-License-Identifier: MIT
#pragma once

#include "common/exit_code.h"
#include "franken/platform/rotation.h"
#include "kiosk/kiosk.h"

#include <filesystem>
#include <optional>
#include <string>
#include <variant>

namespace kiosk {

/// `kiosk`: shows the models.
struct Run {
    RunOptions options;
};
/// `kiosk --frame FILE`: one picture.
struct DrawFrame {
    RunOptions options;
    std::filesystem::path output;
    franken::platform::Size size{1280, 720};
    double seconds = 0;
    std::optional<double>
        loaded; ///< Instead of a model: what is shown until it is there; 0 to 1 of it is done.
};
/// `kiosk check FILE`.
struct CheckFile {
    std::filesystem::path file;
};
/// `kiosk settings`.
struct PrintSettings {};
/// `kiosk doctor`.
struct Examine {
    std::filesystem::path config, report, root = "/";
    bool json = false;
};

using Command = std::variant<ExitCode, Run, DrawFrame, CheckFile, PrintSettings, Examine>;

/// What the command line asks for; or the exit code where there is nothing left to do, because of --help or a
/// mistake that has been reported.
Command parseCommandLine(int count, const char* const* arguments);

} // namespace kiosk
