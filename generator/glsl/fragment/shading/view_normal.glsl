// SPDX-License-Identifier: MIT
// The normal, to be looked at.
//! main
  vec3 color = 0.5 + 0.5 * normal;
