// SPDX-License-Identifier: MIT
// One sun: its direction is the same everywhere.
//! declarations
uniform vec3 u${light}Direction; // lights: towards the sun, unit, world space
uniform vec3 u${light}Radiance; // lights: linear irradiance / pi
//! main
  addLight(Light(u${light}Direction, u${light}Radiance), view, surface, sum);
