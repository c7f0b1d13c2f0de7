// SPDX-License-Identifier: MIT
// The allocator of glibc, counted: functions of these names in the program stand before those of the library,
// which stay within reach by a second name.
#include "support/heap_count.h"

#include <malloc.h>

#include <atomic>
#include <cerrno>

extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void __libc_free(void*);
}

namespace {

std::atomic<std::size_t> bytes{0}, most{0};
thread_local std::size_t calls = 0;

std::size_t sizeOf(void* block) { return block == nullptr ? 0 : malloc_usable_size(block); }

void* taken(void* block) {
    ++calls;
    const std::size_t now = bytes += sizeOf(block);
    std::size_t before = most;
    while (now > before && !most.compare_exchange_weak(before, now)) {
    }
    return block;
}

} // namespace

extern "C" {
void* malloc(std::size_t size) noexcept { return taken(__libc_malloc(size)); }
void* calloc(std::size_t count, std::size_t size) noexcept { return taken(__libc_calloc(count, size)); }
void* memalign(std::size_t alignment, std::size_t size) noexcept {
    return taken(__libc_memalign(alignment, size));
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept { return memalign(alignment, size); }

int posix_memalign(void** block, std::size_t alignment, std::size_t size) noexcept {
    *block = memalign(alignment, size);
    return *block == nullptr ? ENOMEM : 0;
}

void* realloc(void* block, std::size_t size) noexcept {
    const std::size_t before = sizeOf(block);
    void* const grown = __libc_realloc(block, size);
    if (grown != nullptr || size == 0)
        bytes -= before;
    return taken(grown);
}

void free(void* block) noexcept {
    bytes -= sizeOf(block);
    __libc_free(block);
}
}

namespace franken::test {

HeapCount heapCount() { return {calls, bytes, most}; }

void restartMostBytes() { most = bytes.load(); }

} // namespace franken::test
