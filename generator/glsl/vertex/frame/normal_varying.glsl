// SPDX-License-Identifier: MIT
// Hands the normal to the fragment shader.
//! declarations
varying vec3 vNormal;
//! main
  vNormal = normal;
