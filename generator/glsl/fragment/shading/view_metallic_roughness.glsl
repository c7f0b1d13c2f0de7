// SPDX-License-Identifier: MIT
// Roughness and metalness, in the channels of glTF's packed texture.
//! main
  vec3 color = vec3(0.0, roughness, metallic);
