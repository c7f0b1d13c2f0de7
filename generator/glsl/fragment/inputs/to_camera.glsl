// SPDX-License-Identifier: MIT
// Takes vToCamera from the vertex shader.
//! declarations
varying vec3 vToCamera;
