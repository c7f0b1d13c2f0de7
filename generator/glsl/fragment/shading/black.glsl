// SPDX-License-Identifier: MIT
// Nothing lights this surface.
//! main
  vec3 color = vec3(0.0);
