// SPDX-License-Identifier: MIT
// Metalness, 0-1.
//! main
  float metallic = uMetallicRoughness.x;
