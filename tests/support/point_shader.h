// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/pack.h"
#include "franken/program_cache.h"

#include <array>
#include <vector>

namespace franken::test {

/// All that a program is fed with for one point of a surface.
struct ShadedPoint {
    FrameBlock frame{};
    LightsBlock lights{};
    MaterialBlock material{};
    Float3 normal{0, 0, 1};
    Float4 tangent{1, 0, 0, 1};
    Float2 uv{0, 0};
};

/// The point at the world's origin, seen from a direction at distance 1, with a material and one sun of pi
/// lux (a white surface that faces it is 1.0).
ShadedPoint pointAt(const Float3& toCamera, const Float3& toLight, const MaterialFactors& factors, Brdf brdf);

/// Runs a canonical permutation on single points: one pixel each, in a target of 32-bit floats, so that what
/// the program computes is read back as it is, not clipped and not rounded. Empty, with a failure added to
/// the running test, where the program does not compile. Textures are whatever is bound.
std::vector<std::array<float, 4>> shade(const Gl& gl, const Permutation& permutation,
                                        const std::vector<ShadedPoint>& points);

} // namespace franken::test
