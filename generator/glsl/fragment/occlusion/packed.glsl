// SPDX-License-Identifier: MIT
// Ambient occlusion from the metallic-roughness texture, fetched already.
//! declarations
uniform vec2 uOcclusion; // material: strength, 1 - strength
//! main
  float occlusion = orm.r * uOcclusion.x + uOcclusion.y;
