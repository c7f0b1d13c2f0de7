// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/permutation.h"

#include <array>
#include <cstdint>

namespace franken {

/// What ProgramProbe feeds all programs with. One light shines from the eye at a surface that faces it, so
/// that N = V = L: there all BRDFs are alike, and short.
struct ProbeScene {
    static constexpr std::array<float, 3> kBase{0.5f, 0.4f, 0.3f};
    static constexpr float kMetallic = 0.5f, kRoughness = 0.6f;
    static constexpr float kAmbient = 0.2f; ///< Radiance, of the sky as well.
    static constexpr float kLight = 0.1f;   ///< Irradiance over pi, of each light.
    static constexpr float kEmissive = 0.1f;
    static constexpr float kSkybox = 0.5f;
};

/// Whether a pixel, as it is read back, is what a program of the library's own snippets draws of that scene:
/// within an eighth and 8 codes, which targets of 5 bits, 16-bit floats and inexact units stay within, and
/// black, white and NaN do not. A target that encodes by itself may show a program of Output::Linear encoded.
bool isExpected(const Permutation& permutation, const std::array<std::uint8_t, 4>& pixel);

} // namespace franken
