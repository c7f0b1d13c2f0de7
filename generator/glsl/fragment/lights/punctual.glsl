// SPDX-License-Identifier: MIT
// One point light. Its position is given from the eye, so that the vector to the eye serves it too.
//! declarations
uniform vec4 u${light}Position; // lights: from the eye, world space, m; 1 / range^2
uniform vec3 u${light}Radiance; // lights: linear intensity / pi
//! main
  addLight(pointLight(u${light}Position, u${light}Radiance, vToCamera), view, surface, sum);
