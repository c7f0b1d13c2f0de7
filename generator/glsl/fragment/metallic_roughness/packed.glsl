// SPDX-License-Identifier: MIT
// The packed texture: R occlusion, G roughness, B metalness.
//! declarations
uniform sampler2D uMetallicRoughnessTexture; // material: linear
//! main
  vec3 orm = texture2D(uMetallicRoughnessTexture, ${uv}).rgb;
