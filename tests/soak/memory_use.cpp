// SPDX-License-Identifier: MIT
#include "memory_use.h"

#include <malloc.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <new>

namespace {

std::atomic<std::size_t> cppBytes{0};

void* counted(void* memory) {
    if (memory == nullptr)
        throw std::bad_alloc();
    cppBytes += malloc_usable_size(memory);
    return memory;
}

void release(void* memory) {
    cppBytes -= malloc_usable_size(memory);
    std::free(memory);
}

std::size_t roundedUp(std::size_t size, std::size_t alignment) {
    return (size + alignment - 1) / alignment * alignment;
}

} // namespace

void* operator new(std::size_t size) { return counted(std::malloc(size == 0 ? 1 : size)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
    const auto bytes = static_cast<std::size_t>(alignment);
    return counted(std::aligned_alloc(bytes, roundedUp(size, bytes)));
}
void operator delete(void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { release(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }

namespace franken::test {

MemoryUse memoryUse(double seconds) {
    std::size_t pages = 0, residentPages = 0;
    std::ifstream("/proc/self/statm") >> pages >> residentPages;
    const std::filesystem::directory_iterator descriptors("/proc/self/fd");
    const struct mallinfo2 info = mallinfo2();
    return {.seconds = seconds,
            .resident = residentPages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)),
            .heap = info.uordblks + info.hblkhd,
            .cpp = cppBytes,
            .descriptors = static_cast<std::size_t>(std::distance(begin(descriptors), end(descriptors)))};
}

double slope(const std::vector<MemoryUse>& samples, std::size_t MemoryUse::*member) {
    const auto count = static_cast<double>(samples.size());
    double meanTime = 0, meanBytes = 0, products = 0, squares = 0;
    for (const MemoryUse& sample : samples) {
        meanTime += sample.seconds / count;
        meanBytes += static_cast<double>(sample.*member) / count;
    }
    for (const MemoryUse& sample : samples) {
        const double time = sample.seconds - meanTime;
        products += time * (static_cast<double>(sample.*member) - meanBytes);
        squares += time * time;
    }
    return squares > 0 ? products / squares : 0;
}

} // namespace franken::test
