// SPDX-License-Identifier: MIT
// Ambient light alone.
//! main
  vec3 color = base.rgb * irradiance;
