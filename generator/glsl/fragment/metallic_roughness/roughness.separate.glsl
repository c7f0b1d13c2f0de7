// SPDX-License-Identifier: MIT
// Perceptual roughness, 0-1.
//! declarations
uniform sampler2D uRoughnessTexture; // material: R, linear
//! main
  float roughness = texture2D(uRoughnessTexture, ${uv}).r * uMetallicRoughness.y;
