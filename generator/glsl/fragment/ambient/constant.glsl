// SPDX-License-Identifier: MIT
// The same light from everywhere: what a white surface sends back is the light itself.
//! declarations
uniform vec3 uAmbient; // lights: linear radiance
//! main
  vec3 irradiance = uAmbient;
