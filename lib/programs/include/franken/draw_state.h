// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/permutation.h"
#include "franken/generator/texture_role.h"
#include "franken/sampling.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace FRANKEN_API franken {

/// GL state that vc4 and v3d compile into a program: the first draw with a new combination compiles it again.
/// Other state that these drivers compile in is the same in all draws of this library (textures are RGBA8,
/// each attribute has one format, the depth test is on, all channels are written), or belongs to the target
/// (its format and samples).
struct DrawState {
    /// What a texture shows outside of 0-1, across and down.
    struct Wraps {
        /// See Wraps.
        Wrap s = Wrap::Repeat, t = Wrap::Repeat;
        friend bool operator==(const Wraps&, const Wraps&) = default;
    };
    static constexpr Wraps kClamped = {Wrap::ClampToEdge, Wrap::ClampToEdge}; ///< Of skies and lookups.
    /// By sampler unit.
    using AllWraps = std::array<Wraps, kTextureUnits>;

    /// The wraps of texture_role.h: textures repeat, skies are clamped.
    static const AllWraps& usualWraps();

    /// By sampler unit; units that a program does not sample are ignored.
    AllWraps wraps = usualWraps();
    bool blend = false; ///< Source over, without writing depth.

    friend bool operator==(const DrawState&, const DrawState&) = default;
};

/// A program, and the state in which it draws.
struct ProgramUse {
    Permutation permutation; ///< Canonical.
    DrawState state;         ///< How it draws.
    friend bool operator==(const ProgramUse&, const ProgramUse&) = default;
};

/// The state as a number, for comparisons: equal numbers, equal states. Only the units in `units` count (bit
/// n: unit n).
std::uint64_t toBits(const DrawState& state, unsigned units);

} // namespace franken
