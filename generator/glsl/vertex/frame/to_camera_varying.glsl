// SPDX-License-Identifier: MIT
// Hands the vector to the eye to the fragment shader, which normalises it.
//! declarations
varying vec3 vToCamera;
//! main
  vToCamera = toCamera;
