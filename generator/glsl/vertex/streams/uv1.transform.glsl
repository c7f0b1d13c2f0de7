// SPDX-License-Identifier: MIT
// Texture coordinates, stream 1, moved as KHR_texture_transform asks.
//! declarations
attribute vec2 aUv1;
uniform mat3 uUv1Transform; // material: KHR_texture_transform
varying vec2 vUv1;
//! main
  vUv1 = (uUv1Transform * vec3(aUv1, 1.0)).xy;
