// SPDX-License-Identifier: MIT
// One sun whose vectors are in tangent space.
//! declarations
uniform vec3 u${light}Radiance; // lights: linear irradiance / pi
//! main
  addLight(Light(vTo${light}.xyz, u${light}Radiance, vHalf${light}, vTo${light}.w), view, surface, sum);
