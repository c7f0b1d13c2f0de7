// SPDX-License-Identifier: MIT
// Where the vertex is on the screen.
//! declarations
attribute vec3 aPosition;
uniform mat4 uModelViewProjection; // object: model space to clip space
//! main
  gl_Position = uModelViewProjection * vec4(aPosition, 1.0);
