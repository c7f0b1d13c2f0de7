// SPDX-License-Identifier: MIT
#include "franken/draw_state.h"

namespace franken {

std::uint64_t toBits(const DrawState& state, unsigned units) {
    std::uint64_t bits = state.blend ? 1 : 0;
    for (std::size_t unit = 0; unit < DrawState::kUnits; ++unit) {
        const auto [s, t] = state.wraps[unit];
        const bool counts = (units >> unit & 1u) != 0;
        bits = bits << 4 | (counts ? static_cast<unsigned>(s) << 2 | static_cast<unsigned>(t) : 0);
    }
    return bits;
}

} // namespace franken
