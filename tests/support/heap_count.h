// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace franken::test {

/// What the process has taken from the heap, by C and C++, on all threads. Link heap_count.cpp into the
/// test's program itself; not with a sanitizer, which has a heap of its own.
struct HeapCount {
    std::size_t calls = 0; ///< Of malloc() and the like, since the start.
    std::size_t bytes = 0; ///< In use.
    std::size_t most = 0;  ///< The most bytes in use since restartMostBytes().
};

HeapCount heapCount();
void restartMostBytes();

} // namespace franken::test
