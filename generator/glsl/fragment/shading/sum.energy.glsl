// SPDX-License-Identifier: MIT
// All light.
//! main
  vec3 color = sum.color;
