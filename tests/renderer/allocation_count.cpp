// SPDX-License-Identifier: MIT
// In a file of its own, so that the compiler does not look from new into delete.
#include "allocation_count.h"

#include <atomic>
#include <cstdlib>

namespace {

std::atomic<std::size_t> allocations{0};

} // namespace

void* operator new(std::size_t size) {
    ++allocations;
    void* const memory = std::malloc(size == 0 ? 1 : size);
    if (memory == nullptr)
        std::abort();
    return memory;
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace franken::test {

std::size_t allocationCount() { return allocations; }

} // namespace franken::test
