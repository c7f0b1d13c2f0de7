// SPDX-License-Identifier: MIT
// The occlusion, to be looked at.
//! main
  vec3 color = vec3(occlusion);
