// SPDX-License-Identifier: MIT
#include "commands.h"

using namespace franken::cli;

int main(int argc, char** argv) {
    Console console;
    const Command command = parseCommandLine(argc, argv);
    const ExitCode code = std::visit([&](const auto& options) { return run(options, console); }, command);
    if (!console.flush()) {
        console.note("error: standard output cannot be written");
        return static_cast<int>(ExitCode::Device);
    }
    return static_cast<int>(code);
}
