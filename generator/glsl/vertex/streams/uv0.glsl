// SPDX-License-Identifier: MIT
// Texture coordinates, stream 0.
//! declarations
attribute vec2 aUv0;
varying vec2 vUv0;
//! main
  vUv0 = aUv0;
