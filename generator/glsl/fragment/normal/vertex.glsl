// SPDX-License-Identifier: MIT
// The interpolated normal, to unit length.
//! main
  vec3 normal = vNormal * inverseSquareRoot(dot(vNormal, vNormal));
