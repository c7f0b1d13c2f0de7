// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/light.h"

#include <array>
#include <cstdint>
#include <optional>

namespace FRANKEN_API franken {

// Ambient light: all that is known of its kinds, beside their words (choices.cpp) and their snippets
// (recipe.cpp, generator/glsl/fragment/ambient). Radiances are linear.

/// What lights a surface from all sides.
enum class Ambient : std::uint8_t {
    None,
    Color, ///< The same light from everywhere.
    Sky,   ///< Irradiance of a sky, as nine spherical-harmonics coefficients.
};

/// Whether a surface that is turned receives another amount of it, so that its program needs a normal.
constexpr bool dependsOnNormal(Ambient kind) { return kind > Ambient::Color; }

/// What a sky sends to a surface, as the first nine coefficients of its radiance in real spherical
/// harmonics, each RGB, in the order (l, m) = (0,0) (1,-1) (1,0) (1,1) (2,-2) (2,-1) (2,0) (2,1) (2,2).
using SkyCoefficients = std::array<Float3, 9>;

/// Light from all around.
struct AmbientLight {
    Ambient kind = Ambient::None; ///< Which of the next is used.
    Float3 color{0, 0, 0};        ///< Radiance, 0 and up
    SkyCoefficients sky{};        ///< Radiance
};

/// What is wrong with the numbers of any kind, if something is.
std::optional<LightFault> faultOf(const AmbientLight& light);

/// The largest irradiance over pi of a surface that faces along an axis of the world: luminance by
/// Rec. ITU-R BT.709.
double brightestSide(const AmbientLight& light);

/// What programs with ambient light are fed with; a program reads the values of its kind.
struct AmbientBlock {
    Float3 color;              ///< Ambient::Color: radiance of all directions, times the exposure.
    std::array<Float3, 9> sky; ///< The polynomial in the normal that the coefficients make
};

/// Folds the light's kind for programs. Exposure multiplies it. A sky's coefficients are divided by
/// kDielectricScatters: only programs without its reflection take them, where a dielectric scatters what it
/// would reflect as well, and a white one shows the irradiance over pi.
AmbientBlock packAmbient(const AmbientLight& light, float exposure);

/// The same light from everywhere, for programs of every kind: what a program is fed with whose colour is to
/// be known beforehand.
AmbientBlock packEvenAmbient(float radiance);

} // namespace franken
