// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/interface.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace FRANKEN_API franken {

/// The first of `count` consecutive numbers that this process has not handed out before; never 0. Safe on any
/// thread.
std::uint64_t newSerials(std::uint64_t count);

/// One serial.
inline std::uint64_t newSerial() { return newSerials(1); }

/// The values of one block of uniforms, and the serial that identifies them.
struct BlockView {
    const float* values = nullptr; ///< Laid out as fieldOffset() says.
    std::uint64_t serial = 0;      ///< Tells these values from all others: newSerial().
};

/// The uniforms of one draw: a view of each Block, in the order of the enumeration.
using BlockViews = std::array<BlockView, kBlocks>;

/// One of the blocks of generator's pack.h, with a serial that changes whenever the values may have changed.
/// A program uploads a block only when its serial has changed since the last upload: drawing the same object
/// again costs nothing, and two objects that share a block cost one upload.
template<typename Values>
class UniformBlock {
    static_assert(std::is_standard_layout_v<Values> && sizeof(Values) % sizeof(float) == 0,
                  "blocks are plain floats");

public:
    /// The values, for reading.
    const Values& values() const { return m_values; }

    /// The values, for writing. Write before the next draw: later writes through a kept reference are not
    /// uploaded.
    Values& edit() {
        m_serial = newSerial();
        return m_values;
    }

    /// Replaces the values; the serial changes only if the values differ.
    void set(const Values& values) {
        if (std::memcmp(&values, &m_values, sizeof(Values)) != 0)
            edit() = values;
    }

    /// For ShaderProgram::feed().
    BlockView view() const { return {reinterpret_cast<const float*>(&m_values), m_serial}; }

private:
    Values m_values{};
    std::uint64_t m_serial = newSerial();
};

} // namespace franken
