// SPDX-License-Identifier: MIT
#include "helper_threads.h"

#include <algorithm>
#include <system_error>

namespace franken {

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

} // namespace franken
