// SPDX-License-Identifier: MIT
// No occlusion: white.
//! main
  vec3 color = vec3(1.0);
