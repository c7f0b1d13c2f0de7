// SPDX-License-Identifier: MIT
#include "session.h"
#include "watch.h"

#include <iostream>

using namespace franken;

namespace {

void logToStderr(LogLevel level, std::string_view message) {
    if (level != LogLevel::Info)
        std::cerr << "viewer: warning: " << message << "\n";
}

ExitCode run(const Options& options) {
    Session session(options, logToStderr);
    if (options.watch) {
        watch(session, options);
        return ExitCode::Ok;
    }
    const std::optional<Failure> failure =
        options.permutations ? session.printPermutations() : session.draw();
    if (!failure)
        return ExitCode::Ok;
    std::cerr << "viewer: error: " << toString(failure->error) << "\n";
    return failure->code;
}

} // namespace

int main(int argc, char** argv) {
    const std::variant<ExitCode, Options> parsed = parseCommandLine(argc, argv);
    if (const ExitCode* code = std::get_if<ExitCode>(&parsed))
        return static_cast<int>(*code);
    return static_cast<int>(run(std::get<Options>(parsed)));
}
