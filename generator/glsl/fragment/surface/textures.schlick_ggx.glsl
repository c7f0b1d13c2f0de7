// SPDX-License-Identifier: MIT
// Metalness and roughness by texture.
//! functions
// metallic, roughness: 0-1. The roughness is kept off 0, where a sun's highlight has no size.
Surface surfaceOf(float metallic, float roughness) {
  float r = max(roughness, 0.001);
  float alpha = r * r;
  float alpha2 = alpha * alpha;
  vec2 smith = vec2(1.0 - 0.5 * alpha, 0.5 * alpha);
  return Surface(0.96 - 0.96 * metallic, metallic, 0.96 + 0.04 * metallic, 1.0 - alpha2, smith, 0.25 * alpha2);
}
//! main
  Surface surface = surfaceOf(metallic, roughness);
