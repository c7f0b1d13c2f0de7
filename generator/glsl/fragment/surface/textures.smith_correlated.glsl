// SPDX-License-Identifier: MIT
// Metalness and roughness by texture.
//! functions
// metallic, roughness: 0-1. The roughness is kept off 0, where a sun's reflection has no size.
Surface surfaceOf(float metallic, float roughness) {
  float r = max(roughness, 0.001);
  float alpha2 = (r * (r * r)) * r;
  float slope = 1.0 - alpha2;
  return Surface(0.96 - 0.96 * metallic, metallic, 0.96 + 0.04 * metallic, slope, vec2(slope, alpha2), 0.5 * alpha2);
}
//! main
  Surface surface = surfaceOf(metallic, roughness);
