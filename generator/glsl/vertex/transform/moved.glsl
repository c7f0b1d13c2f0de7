// SPDX-License-Identifier: MIT
// The vertex, for an effect to move.
//! declarations
attribute vec3 aPosition;
//! main
  vec3 position = aPosition;
