// SPDX-License-Identifier: MIT
#include "helper_threads.h"

#include <algorithm>
#include <atomic>
#include <system_error>

namespace franken {
namespace {

constexpr std::size_t kMaxRowWorkers = 16;

} // namespace

std::vector<std::jthread> startHelpers(std::size_t workers, const std::function<void()>& work) {
    const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
    std::vector<std::jthread> helpers;
    try {
        for (std::size_t i = 1; i < std::min(cores, workers); ++i)
            helpers.emplace_back(std::cref(work));
    } catch (const std::system_error&) { // no more threads to be had: the caller does the rest
    }
    return helpers;
}

void forEachRow(int count, const std::function<void(int)>& row, const std::function<void(float)>& progress) {
    std::atomic<int> next = 0;
    const std::function<void()> work = [&] {
        for (int y = next++; y < count; y = next++)
            row(y);
    };
    std::vector<std::jthread> helpers = startHelpers(kMaxRowWorkers, work);
    for (int y = next++; y < count; y = next++) {
        row(y);
        if (progress)
            progress(static_cast<float>(y) / static_cast<float>(count));
    }
    helpers.clear();
    if (progress)
        progress(1);
}

} // namespace franken
