// SPDX-License-Identifier: MIT
#pragma once

#include "franken/result.h"

#include <cstdint>
#include <optional>

namespace franken {

/// Owns GL objects. A renderer keeps a list of its owners, and asks each of them when the context is lost,
/// when there is another one, and when memory is needed.
class GlOwner {
public:
    GlOwner() = default;
    GlOwner(const GlOwner&) = delete;
    GlOwner& operator=(const GlOwner&) = delete;
    virtual ~GlOwner() = default;

    /// The context is gone, and the device's table deletes nothing: drops all GL objects.
    virtual void lost() = 0;

    /// Rebuilds all that is needed in a new context, which is current. Where something cannot be rebuilt, the
    /// rest is, and the first error is returned.
    virtual Result<void> restore() = 0;

    /// By Device::clock, the last use of the least recently used thing that can be evicted; nothing where
    /// there is none.
    virtual std::optional<std::uint64_t> oldestUse() const { return std::nullopt; }
    /// Evicts that thing.
    virtual void evictOldest() {}
};

/// The first of several errors.
class FirstError {
public:
    void add(Result<void> next) {
        if (m_first && !next)
            m_first = std::move(next);
    }
    Result<void> take() { return std::move(m_first); }

private:
    Result<void> m_first;
};

} // namespace franken
