// SPDX-License-Identifier: MIT
// Takes vUv0 from the vertex shader.
//! declarations
varying vec2 vUv0;
