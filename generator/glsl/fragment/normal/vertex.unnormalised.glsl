// SPDX-License-Identifier: MIT
// The interpolated normal, as it comes.
//! main
  vec3 normal = vNormal;
