// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"

#include <array>

namespace FRANKEN_API franken {

// Lights as applications give them; pack.h folds them for programs.

using Float2 = std::array<float, 2>;
using Float3 = std::array<float, 3>;
using Double3 = std::array<double, 3>;
using Float4 = std::array<float, 4>;
using Float9 = std::array<float, 9>;   ///< A mat3, column by column.
using Float16 = std::array<float, 16>; ///< A mat4, column by column.

/// A directional light (KHR_lights_punctual). pi lux make a white surface that faces it 1.0.
struct Sun {
    Float3 direction{0, -1, 0}; ///< Where its light travels, world space; any length but 0
    Float3 color{1, 1, 1};      ///< Linear
    float illuminance = 0;      ///< lux, 0 and up
    bool ofSky = false;         ///< Taken out of a sky: where that is turned, the direction turns with it.
};

/// A point or spot light (KHR_lights_punctual).
struct PunctualLight {
    Double3 position{0, 0, 0};  ///< World space, m
    Float3 direction{0, 0, -1}; ///< Where a spot shines, world space; any length but 0
    Float3 color{1, 1, 1};      ///< Linear
    float intensity = 0;        ///< candela, 0 and up
    float range = 0;            ///< m; 0 is infinite
    bool spot = false;
    float innerCone = 0;           ///< radians, 0 to outerCone
    float outerCone = 0.78539816f; ///< radians, up to pi/2
};

/// What a sky sends to a surface, as the first nine coefficients of its radiance in real spherical
/// harmonics, each RGB, in the order (l, m) = (0,0) (1,-1) (1,0) (1,1) (2,-2) (2,-1) (2,0) (2,1) (2,2).
using SkyCoefficients = std::array<Float3, 9>;

} // namespace franken
