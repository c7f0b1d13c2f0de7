// SPDX-License-Identifier: MIT
// The vector to the eye as an effect takes it: m, world space, not normalised. The vertex shader scaled it.
//! declarations
uniform float uLengthUnit; // frame: brings the scaled vector to the eye back to m
//! main
  vec3 toEye = vToCamera * uLengthUnit;
