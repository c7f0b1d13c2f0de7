// SPDX-License-Identifier: MIT
// One sun whose angle to the eye came from the vertex shader.
//! declarations
uniform mediump vec3 u${light}Direction; // lights: towards the sun, unit, world space
uniform vec3 u${light}Radiance; // lights: linear irradiance / pi
//! main
  addLight(Light(u${light}Direction, u${light}Radiance, vVDotL.${lane}, vFresnel.${lane}), view, surface, sum);
