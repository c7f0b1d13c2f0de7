// SPDX-License-Identifier: MIT
#include "franken/draw_state.h"

namespace franken {

const DrawState::AllWraps& DrawState::usualWraps() {
    static const AllWraps all = [] {
        AllWraps usual;
        for (const TextureRoleRow& role : textureRoles())
            if (!role.repeats)
                usual[role.unit] = kClamped;
        return usual;
    }();
    return all;
}

std::uint64_t toBits(const DrawState& state, unsigned units) {
    constexpr unsigned kWraps = 3; // Two of 3 ways at 16 units are 9^16: 51 bits.
    std::uint64_t bits = state.blend ? 1 : 0;
    for (std::size_t unit = 0; unit < kTextureUnits; ++unit) {
        const auto [s, t] = state.wraps[unit];
        const bool counts = (units >> unit & 1u) != 0;
        bits = bits * kWraps * kWraps +
               (counts ? static_cast<unsigned>(s) * kWraps + static_cast<unsigned>(t) : 0);
    }
    return bits;
}

} // namespace franken
