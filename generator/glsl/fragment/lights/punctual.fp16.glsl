// SPDX-License-Identifier: MIT
// One point light. The vector to it comes from the vertex shader, which has the digits to subtract.
//! declarations
uniform vec3 u${light}Radiance; // lights: linear intensity / pi, times the square of the scale
uniform float u${light}Window; // lights: 1 / range^2, over the square of the scale
varying vec3 vTo${light};
//! main
  addLight(pointLight(vTo${light}, u${light}Radiance, u${light}Window), view, surface, sum);
