// SPDX-License-Identifier: MIT
// The vector to the eye as an effect takes it: m, world space, not normalised.
//! main
  vec3 toEye = vToCamera;
