// SPDX-License-Identifier: MIT
// No ambient light.
//! main
  vec3 irradiance = vec3(0.0);
