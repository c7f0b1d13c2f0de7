// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

namespace franken {

/// Starts `work` on threads beside this one: with it, as many as there are cores and at most `workers`, or
/// fewer where the system gives no more. They end before what is returned does; `work` has to live until
/// then.
std::vector<std::jthread> startHelpers(std::size_t workers, const std::function<void()>& work);

/// Calls row(0) to row(count - 1), on as many threads as there are cores. progress, where there is one, is
/// called on this thread with the share that is done, 0 to 1.
void forEachRow(int count, const std::function<void(int)>& row, const std::function<void(float)>& progress);

} // namespace franken
