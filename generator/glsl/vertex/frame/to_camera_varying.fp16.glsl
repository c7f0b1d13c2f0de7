// SPDX-License-Identifier: MIT
// Hands the vector to the eye to the fragment shader, which normalises it: scaled so that the square of its length is a
// 16-bit float.
//! declarations
uniform float uLengthScale; // frame: makes the farthest surface's distance 60 at most
varying vec3 vToCamera;
//! main
  vToCamera = toCamera * uLengthScale;
