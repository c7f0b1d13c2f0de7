// SPDX-License-Identifier: MIT
// The vertex, moved by its joints.
//! declarations
attribute vec3 aPosition;
//! main
  vec4 boundPosition = vec4(aPosition, 1.0);
  vec3 position = vec3(dot(skinX, boundPosition), dot(skinY, boundPosition), dot(skinZ, boundPosition));
