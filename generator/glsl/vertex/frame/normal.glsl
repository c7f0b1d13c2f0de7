// SPDX-License-Identifier: MIT
// The normal in world space. The matrix is the inverse transpose of the model's upper 3x3: a mat4 with a
// zero fourth component, normalised before .xyz, would let a translation leak in.
//! declarations
attribute vec3 aNormal;
uniform mat3 uNormalMatrix; // object: inverse transpose of the model matrix
//! main
  vec3 normal = normalize(uNormalMatrix * aNormal);
