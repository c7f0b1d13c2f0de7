// SPDX-License-Identifier: MIT
#pragma once

#include "frame_counts.h"
#include "program_cost.h"

#include <span>
#include <string>
#include <vector>

namespace price {

/// A Raspberry Pi and its GPU, of the table in generator/cli/gpu.h.
struct Machine {
    franken::cli::Gpu gpu;
    franken::cli::PiModel model;
};

/// From the slowest to the fastest.
std::vector<Machine> machines();

/// Of the share that memory can move at best, what the GPU gets of it: an estimate, as the processor and the
/// display ask for the rest.
inline constexpr double kMemoryShare = 0.5;

/// One program of a frame.
struct ProgramBill {
    franken::Permutation program;
    ProgramCost cost;
    Shaded shaded;
    std::size_t vertices = 0, tileVertices = 0;
    double lookups = 0; ///< Of the texture units, in all its pixels.
    /// On all QPUs, nothing ever waited for.
    double fragmentMilliseconds = 0, vertexMilliseconds = 0;
};

/// What the time of a frame goes by.
enum class Bound { Pixels, Vertices, TextureUnits, Memory };

/// "pixels", "vertices", "texture units", "memory".
std::string_view toString(Bound bound);

/// What memory moves for a frame, bytes.
struct Traffic {
    double texels = 0;   ///< Of textures.
    double vertices = 0; ///< Positions for the coordinate shader, all attributes for the vertex shader.
    double stores =
        0; ///< The target's colour, once. It is cleared, so nothing is loaded, and depth stays in tiles.
    double sum() const { return texels + vertices + stores; }
};

/// What a frame takes on a machine. The parts run beside each other, so that the longest is the least that a
/// frame takes, and their sum the most, where none hides another.
struct FrameBill {
    Machine machine;
    std::vector<ProgramBill> programs; ///< The dearest first.
    Traffic traffic;
    double pixels = 0, vertices = 0, textureUnits = 0, memory = 0; ///< Milliseconds.

    double least() const;
    double most() const { return pixels + vertices + textureUnits + memory; }
    Bound bound() const;
};

/// What is changed of a frame before it is priced.
struct Terms {
    franken::Lighting lighting;
    franken::Look look;
    bool halvedTextures = false; ///< The materials'.
};

/// The program of each draw under these terms. Fails as permutationOf() does.
franken::Result<std::vector<franken::Permutation>> programsOf(const FrameCounts& counts, const Terms& terms);

/// One program and one cost for each draw. What has an error costs nothing: it is not drawn.
FrameBill billOf(const FrameCounts& counts, const Terms& terms, const Machine& machine,
                 std::span<const franken::Permutation> programs, std::span<const ProgramCost> costs);

} // namespace price
