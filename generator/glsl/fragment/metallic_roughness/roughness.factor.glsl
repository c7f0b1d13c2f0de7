// SPDX-License-Identifier: MIT
// Perceptual roughness, 0-1.
//! main
  float roughness = uMetallicRoughness.y;
