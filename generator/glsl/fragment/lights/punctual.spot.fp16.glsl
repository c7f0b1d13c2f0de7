// SPDX-License-Identifier: MIT
// One spot light. The vector to it comes from the vertex shader, which has the digits to subtract.
//! declarations
uniform vec3 u${light}Radiance; // lights: linear intensity / pi, times the square of the scale
uniform float u${light}Window; // lights: 1 / range^2, over the square of the scale
uniform vec3 u${light}Axis; // lights: where it shines, unit, world space
uniform vec2 u${light}Cone; // lights: scale and offset, by 1 - cos
varying vec3 vTo${light};
//! main
  Light spot${light} = spotLight(vTo${light}, u${light}Radiance, u${light}Window, u${light}Axis, u${light}Cone);
  addLight(spot${light}, view, surface, sum);
