// SPDX-License-Identifier: MIT
// What a surface makes of the sky's light.
//! functions
struct Share { // of the sky's light
  float scattered; // of the irradiance, tinted by the base colour
  float squared; // of the reflection, tinted twice: scattered between a metal's facets
  float tinted; // of the reflection, tinted by the base colour
  float untinted; // of the reflection
};
