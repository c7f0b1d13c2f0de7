// SPDX-License-Identifier: MIT
// Takes vDirection from the vertex shader.
//! declarations
varying vec3 vDirection;
