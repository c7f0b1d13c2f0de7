// SPDX-License-Identifier: MIT
// Where the application's effect puts the vertex, and where that is on the screen.
//! declarations
attribute vec3 aPosition;
uniform mat4 uModelViewProjection; // object: model space to clip space
//! main
  vec3 position = ${call};
  gl_Position = uModelViewProjection * vec4(position, 1.0);
