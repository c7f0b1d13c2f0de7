// SPDX-License-Identifier: MIT
// Metalness, 0-1.
//! declarations
uniform sampler2D uMetallicTexture; // material: R, linear
//! main
  float metallic = texture2D(uMetallicTexture, ${uv}).r * uMetallicRoughness.x;
