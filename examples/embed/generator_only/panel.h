// SPDX-License-Identifier: MIT
#pragma once

#include <franken/generator/pack.h>

// What is drawn: a panel of 2 x 2 metres in the plane z = 0 that fills the picture, lit by one sun and seen
// by an eye close to it, so that its highlight has a place and a shape.

inline constexpr int kPixels = 128; ///< Width and height of the picture.
inline constexpr franken::Float3 kEye = {0.3f, -0.2f, 1.4f};
inline constexpr franken::Sun kSun = {
    .direction = {0.5f, -0.4f, -1.0f}, .color = {1, 1, 1}, .illuminance = 3.14159265f};
inline constexpr franken::MaterialFactors kPanel = {
    .baseColor = {0.6f, 0.25f, 0.1f, 1}, .metallic = 0.5f, .roughness = 0.45f};
