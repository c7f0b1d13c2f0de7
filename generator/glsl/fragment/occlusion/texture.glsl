// SPDX-License-Identifier: MIT
// Ambient occlusion from a texture of its own.
//! declarations
uniform sampler2D uOcclusionTexture; // material: R, linear
uniform vec2 uOcclusion; // material: strength, 1 - strength
//! main
  float occlusion = texture2D(uOcclusionTexture, ${uv}).r * uOcclusion.x + uOcclusion.y;
