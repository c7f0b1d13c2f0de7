// SPDX-License-Identifier: MIT
#include "franken/gpu_memory.h"

#include <string>

namespace franken {
namespace {

std::string kibibytes(std::size_t bytes) { return std::to_string((bytes + 1023) / 1024) + " KiB"; }

} // namespace

MemoryLease::MemoryLease(std::shared_ptr<Used> used, MemoryUse use, std::size_t bytes)
    : m_used(std::move(used)), m_use(use), m_bytes(bytes) {
    (*m_used)[static_cast<std::size_t>(use)] += bytes;
}

MemoryLease::~MemoryLease() {
    if (m_used)
        (*m_used)[static_cast<std::size_t>(m_use)] -= m_bytes;
}

bool GpuMemory::evictAll() {
    const unsigned before = m_evictions;
    while (m_evict && m_evict())
        ++m_evictions;
    return m_evictions != before;
}

Result<MemoryLease> GpuMemory::reserve(MemoryUse use, std::size_t bytes) {
    const auto fits = [&] { return used() <= m_budget && bytes <= m_budget - used(); };
    while (!fits() && m_evict && m_evict())
        ++m_evictions;
    if (fits())
        return MemoryLease(m_used, use, bytes);
    return Error{"memory.budget", "",
                 kibibytes(bytes) + " more do not fit into the budget of " + kibibytes(m_budget) +
                     " of GPU memory, of which " + kibibytes(used()) + " are in use",
                 "use smaller textures, show less at a time, or raise the budget"};
}

} // namespace franken
