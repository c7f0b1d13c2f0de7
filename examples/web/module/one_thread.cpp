// SPDX-License-Identifier: MIT
// What a page does in place of threads and exceptions.
#include "helper_threads.h"

#include <cstddef>
#include <cstdlib>

namespace franken {

std::vector<std::jthread> startHelpers(std::size_t, const std::function<void()>&) { return {}; }

void forEachRow(int count, const std::function<void(int)>& row, const std::function<void(float)>& progress) {
    for (int y = 0; y < count; ++y) {
        row(y);
        if (progress)
            progress(static_cast<float>(y + 1) / static_cast<float>(count));
    }
}

} // namespace franken

// Debian's libc++abi for WASI cannot throw. A parser that would throws ends the module, which the page
// notices as a trap and starts again.
extern "C" {
void* __cxa_allocate_exception(std::size_t) { std::abort(); }
void __cxa_throw(void*, void*, void (*)(void*)) { std::abort(); }
}
