// SPDX-License-Identifier: MIT
// Takes vNormal from the vertex shader.
//! declarations
varying vec3 vNormal;
