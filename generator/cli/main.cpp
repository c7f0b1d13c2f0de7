// SPDX-License-Identifier: MIT
#include "commands.h"
#include "json.h"

#include <cstdio>
#include <exception>

using namespace franken::cli;

namespace {

ExitCode runCommand(int argc, const char* const* argv) {
    Console console;
    const Command command = parseCommandLine(argc, argv, console);
    const ExitCode code = std::visit([&](const auto& options) { return run(options, console); }, command);
    console.endErrors();
    if (console.answersInJson() && !console.errors().empty())
        console.write(errorsJson(console.errors()));
    if (console.flush())
        return code;
    console.note("error: standard output cannot be written");
    return ExitCode::Device;
}

} // namespace

// Whatever a user can cause is a Result; what is left to be thrown is a machine without memory.
int main(int argc, char** argv) {
    try {
        return static_cast<int>(runCommand(argc, argv));
    } catch (const std::exception& exception) {
        std::fprintf(stderr, "frankenshader: error: %s\n", exception.what());
        return static_cast<int>(ExitCode::Device);
    }
}
