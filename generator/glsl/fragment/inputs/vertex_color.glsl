// SPDX-License-Identifier: MIT
// Takes vColor from the vertex shader.
//! declarations
varying vec4 vColor;
