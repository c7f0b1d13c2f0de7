// SPDX-License-Identifier: MIT
// Where the moved vertex is on the screen.
//! declarations
uniform mat4 uModelViewProjection; // object: model space to clip space
//! main
  gl_Position = uModelViewProjection * vec4(position, 1.0);
