// SPDX-License-Identifier: MIT
// Takes vUv1 from the vertex shader.
//! declarations
varying vec2 vUv1;
