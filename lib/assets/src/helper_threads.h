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

} // namespace franken
