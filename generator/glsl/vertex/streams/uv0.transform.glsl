// SPDX-License-Identifier: MIT
// Texture coordinates, stream 0, moved as KHR_texture_transform asks.
//! declarations
attribute vec2 aUv0;
uniform mat3 uUv0Transform; // material: KHR_texture_transform
varying vec2 vUv0;
//! main
  vUv0 = (uUv0Transform * vec3(aUv0, 1.0)).xy;
