// SPDX-License-Identifier: MIT
// One spot light. Its position is given from the eye, so that the vector to the eye serves it too.
//! declarations
uniform vec4 u${light}Position; // lights: from the eye, world space, m; 1 / range^2
uniform vec3 u${light}Radiance; // lights: linear intensity / pi
uniform vec3 u${light}Axis; // lights: where it shines, unit, world space
uniform vec2 u${light}Cone; // lights: scale and offset
//! main
  Light spot${light} = spotLight(u${light}Position, u${light}Radiance, u${light}Axis, u${light}Cone, vToCamera);
  addLight(spot${light}, view, surface, sum);
