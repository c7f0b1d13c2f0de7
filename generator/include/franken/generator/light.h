// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"

#include <array>
#include <optional>
#include <string_view>

namespace FRANKEN_API franken {

// Lights with a direction or a place, as applications give them (ambient.h has the light from all around);
// pack.h folds them for programs.

/// The library's plain vectors: this part has no GLM.
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
    Double3 position{0, 0, 0};     ///< World space, m
    Float3 direction{0, 0, -1};    ///< Where a spot shines, world space; any length but 0
    Float3 color{1, 1, 1};         ///< Linear
    float intensity = 0;           ///< candela, 0 and up
    float range = 0;               ///< m; 0 is infinite
    bool spot = false;             ///< It has a cone; else it is a point light, and the angles are ignored.
    float innerCone = 0;           ///< radians, 0 to outerCone
    float outerCone = 0.78539816f; ///< radians, up to pi/2
};

/// What is wrong with a light's numbers: the member, and the rule that it breaks.
struct LightFault {
    std::string_view where; ///< "direction"
    std::string_view what;  ///< "it must be finite, and not 0"
};

/// The first fault, if there is one.
std::optional<LightFault> faultOf(const Sun& sun);
std::optional<LightFault> faultOf(const PunctualLight& light);

/// Of a linear colour, by Rec. ITU-R BT.709.
constexpr double luminance(const Float3& color) {
    return 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
}

} // namespace franken
