// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/result.h"

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <utility>

namespace FRANKEN_API franken {

/// What GPU memory is used for.
enum class MemoryUse { Textures, Meshes, Targets };

class GpuMemory;

/// A reserved amount of GPU memory, released by the destructor. Movable, not copyable.
class MemoryLease {
public:
    MemoryLease() = default;
    MemoryLease(MemoryLease&& other) noexcept
        : m_used(std::move(other.m_used)), m_use(other.m_use), m_bytes(std::exchange(other.m_bytes, 0)) {}
    MemoryLease& operator=(MemoryLease&& other) noexcept {
        std::swap(m_used, other.m_used);
        std::swap(m_use, other.m_use);
        std::swap(m_bytes, other.m_bytes);
        return *this;
    }
    ~MemoryLease();

    /// What is held.
    std::size_t bytes() const { return m_bytes; }

private:
    friend class GpuMemory;
    using Used = std::array<std::size_t, 3>; ///< Bytes, by MemoryUse.
    MemoryLease(std::shared_ptr<Used> used, MemoryUse use, std::size_t bytes);

    std::shared_ptr<Used> m_used; ///< Outlives the GpuMemory where a lease does.
    MemoryUse m_use = MemoryUse::Textures;
    std::size_t m_bytes = 0;
};

/// Counts the bytes that textures, meshes and targets take on the GPU, and refuses allocations above a budget
/// before the driver does: a driver without free memory may end the process, draw nothing or take the
/// screen's memory. A Pi 0 to 3 allocates from the contiguous memory (CMA) that its kernel sets aside, 64 to
/// 256 MB, which also holds the screen's buffers; a budget of half of it is a good start.
///
/// Bytes are counted as requested (width * height * 4 for each level of a texture). Drivers round up, which
/// is not counted: vc4 and v3d to tiles of 4 KiB and, without mipmaps, by some percent. Not thread-safe: use
/// it on the thread of its context.
class GpuMemory {
public:
    /// For setBudget(): what the driver has.
    static constexpr std::size_t kUnlimited = std::numeric_limits<std::size_t>::max();

    /// Evicts something that can be loaded again; false where there is nothing left to evict.
    using Evict = std::function<bool()>;

    /// Frees nothing now; where the new budget is already exceeded, the next reserve() evicts.
    void setBudget(std::size_t bytes) { m_budget = bytes; }
    /// Bytes.
    std::size_t budget() const { return m_budget; }

    /// Who is asked to make room; none at first.
    void setEvict(Evict evict) { m_evict = std::move(evict); }

    /// Bytes in use for that.
    std::size_t used(MemoryUse use) const { return (*m_used)[static_cast<std::size_t>(use)]; }
    /// Bytes in use for everything.
    std::size_t used() const { return (*m_used)[0] + (*m_used)[1] + (*m_used)[2]; }

    /// How often something was evicted.
    unsigned evictions() const { return m_evictions; }

    /// Evicts everything that can be evicted, for when the driver itself has no memory left. Returns whether
    /// anything was evicted.
    bool evictAll();

    /// Reserves bytes of the budget before GL allocates them; where they do not fit, evicts until they do.
    /// Fails with "memory.budget", which names the figures; evicted things stay evicted. Applications reserve
    /// their own render targets too: width * height * 4 for RGBA8, the same for depth with stencil, times the
    /// samples.
    Result<MemoryLease> reserve(MemoryUse use, std::size_t bytes);

private:
    std::shared_ptr<MemoryLease::Used> m_used = std::make_shared<MemoryLease::Used>();
    std::size_t m_budget = kUnlimited;
    unsigned m_evictions = 0;
    Evict m_evict;
};

} // namespace franken
