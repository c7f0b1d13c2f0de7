// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/permutation.h"
#include "franken/result.h"

#include <span>
#include <string_view>

namespace franken::cli {

/// A Raspberry Pi, as far as its GPU is concerned.
struct PiModel {
    std::string_view name;
    int megahertz;          ///< The clock of the 3D block while it draws.
    std::string_view word;  ///< "pi3", for command lines.
    int megabytesPerSecond; ///< What its memory can move at best, whoever asks for it.
};

/// One of the three generations of the Raspberry Pi's GPU that Mesa's compilers tell apart.
///
/// A QPU is four lanes wide and runs one instruction, an addition and a multiplication at most, for 16 pixels
/// or vertices in four clocks (Broadcom, VideoCore IV 3D Architecture Reference Guide, 2013); Mesa's drivers
/// know no other shape for the later ones.
///
/// QPUs: VideoCore IV has 12 on every Raspberry Pi (3 slices of 4); the kernel's v3d_ident says 8 on a Pi 4
/// and 16 on a Pi 5. Clocks: the table of v3d_freq in the Raspberry Pi documentation (config.txt,
/// overclocking), as of 2025. Two depart from it: the Pi 3 has 400 MHz there and 300 in older firmware, and
/// we count with the smaller; the Pi 5 ran at 800 MHz when it came out, at 910 later, and is said to have 960
/// now.
///
/// Memory: sdram_freq of the same table, of a bus of 32 bits that moves data twice a clock (LPDDR2: Pi 1 400
/// MHz, Pi 0, 2 and 3 450) or as often as the number says (LPDDR4 and LPDDR4X: Pi 4 3200, Pi 5 4267). A Pi 3
/// B+ has 500.
///
/// Texture units: the SoC of the Pi 1 was announced with 1.5 G texels a second at 250 MHz, which are 6 a
/// clock: two units for each slice. Nobody has published what those of v3d do.
struct Gpu {
    std::string_view name;    ///< "vc4"
    std::string_view meaning; ///< "VideoCore IV: Raspberry Pi 0 to 3"
    Target target;            ///< The forms that a program for it is made of.
    int qpus;
    int texelsPerClock; ///< That all texture units look up together; 0 where it is not known.
    std::span<const PiModel> models;
};

std::span<const Gpu> gpus();

/// Fails with "cost.unknown-gpu"; the remedy lists the names.
Result<Gpu> findGpu(std::string_view name);

/// What a program for that GPU is made of: the permutation as it is, or with the GPU's target where it is
/// generic, as a runtime would choose. Canonical in, canonical out.
Permutation forGpu(const Permutation& permutation, const Gpu& gpu);

/// Pixels (or vertices) a second, in millions, that take so many instructions each, on all QPUs, if nothing
/// is ever waited for: no texture, no memory, no tile, no vertex. A real picture takes longer.
double megapixelsPerSecond(const Gpu& gpu, const PiModel& model, int instructions);

} // namespace franken::cli
