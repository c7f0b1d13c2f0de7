// SPDX-License-Identifier: MIT
// One sun beside punctual lights: its direction is the same everywhere, and nothing attenuates it.
//! declarations
uniform vec3 u${light}Direction; // lights: towards the sun, unit, world space
uniform vec3 u${light}Radiance; // lights: linear irradiance / pi
//! main
  addLight(Light(u${light}Direction, u${light}Radiance, 1.0, 1.0), view, surface, sum);
