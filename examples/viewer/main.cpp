// SPDX-License-Identifier: MIT
#include "franken/printable.h"
#include "session.h"
#include "watch.h"

#include <iostream>
#include <malloc.h>

using namespace franken;

namespace {

void logToStderr(LogLevel level, std::string_view message) {
    if (level != LogLevel::Info)
        std::cerr << "viewer: warning: " << printableMessage(message) << "\n";
}

std::optional<Failure> work(Session& session, const Options& options) {
    if (options.list)
        return session.printList();
    if (options.pick)
        return session.printPick();
    if (options.permutations)
        return session.printPermutations();
    if (options.watch)
        watch(session, options);
    else if (std::optional<Failure> failure = session.draw())
        return failure;
    return session.keepManifest();
}

ExitCode run(const Options& options) {
    Session session(options, logToStderr);
    const std::optional<Failure> failure = work(session, options);
    if (!failure)
        return ExitCode::Ok;
    std::cerr << "viewer: error: " << printable(failure->error) << "\n";
    return failure->code;
}

} // namespace

int main(int argc, char** argv) {
#ifdef __GLIBC__
    // What is freed goes back to the system at once. glibc would keep images for others as large, and hand
    // their pages to Mesa's softpipe, whose contexts allocate 220 MiB and touch little of it.
    mallopt(M_MMAP_THRESHOLD, 64 << 10);
#endif
    const std::variant<ExitCode, Options> parsed = parseCommandLine(argc, argv);
    if (const ExitCode* code = std::get_if<ExitCode>(&parsed))
        return static_cast<int>(*code);
    return static_cast<int>(run(std::get<Options>(parsed)));
}
