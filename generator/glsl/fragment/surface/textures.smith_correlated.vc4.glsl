// SPDX-License-Identifier: MIT
// Metalness and roughness by texture.
//! functions
// metallic, roughness: 0-1. The roughness is kept off 0, where a sun's highlight has no size.
Surface surfaceOf(float metallic, float roughness) {
  float r = max(roughness, 0.001);
  float alpha2 = (r * r) * (r * r);
  Surface surface;
  surface.diffuse = 0.96 - 0.96 * metallic;
  surface.metal = metallic;
  surface.oneMinusF0 = 0.96 + 0.04 * metallic;
  surface.slope = 1.0 - alpha2;
  surface.smith = vec2(surface.slope, alpha2);
  surface.gain = 0.5 * alpha2;
  return surface;
}
//! main
  Surface surface = surfaceOf(metallic, roughness);
