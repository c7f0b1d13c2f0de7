// SPDX-License-Identifier: MIT
#include "watch.h"

#include "file_times.h"
#include "franken/printable.h"

#include <chrono>
#include <csignal>
#include <iostream>
#include <thread>

namespace {

volatile std::sig_atomic_t stopped = 0;

void waitALittle() { std::this_thread::sleep_for(std::chrono::milliseconds(100)); }

// Until two looks in a row see the same: editors write in steps.
FileTimes settledTimes(const Options& options) {
    FileTimes before = inputTimes(options);
    while (stopped == 0) {
        waitALittle();
        FileTimes now = inputTimes(options);
        if (now == before)
            break;
        before = std::move(now);
    }
    return before;
}

} // namespace

void watch(Session& session, const Options& options) {
    for (const int signal : {SIGINT, SIGTERM})
        std::signal(signal, [](int) { stopped = 1; });
    while (stopped == 0) {
        const FileTimes drawn = settledTimes(options);
        if (const std::optional<Failure> failure = session.draw())
            std::cerr << "viewer: error: " << franken::printable(failure->error)
                      << "\nviewer: kept the last good picture\n";
        else
            std::cerr << "viewer: wrote " << franken::printable(options.output.string()) << "\n";
        while (stopped == 0 && inputTimes(options) == drawn)
            waitALittle();
    }
}
