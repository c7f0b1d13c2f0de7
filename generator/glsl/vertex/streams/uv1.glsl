// SPDX-License-Identifier: MIT
// Texture coordinates, stream 1.
//! declarations
attribute vec2 aUv1;
varying vec2 vUv1;
//! main
  vUv1 = aUv1;
