// SPDX-License-Identifier: MIT
// Metalness and roughness by texture.
//! functions
// metallic, roughness: 0-1. The roughness is kept off 0, where a sun's highlight has no size.
Surface surfaceOf(vec3 base, float metallic, float roughness) {
  float r = max(roughness, 0.001);
  float alpha = r * r;
  float alpha2 = alpha * alpha;
  float k = 0.125 * (roughness + 1.0) * (roughness + 1.0);
  float dielectric = 0.04 - 0.04 * metallic;
  float scattered = 1.0 - metallic;
  Surface surface;
  surface.base = base;
  surface.diffuse = scattered - scattered * dielectric;
  surface.tinted = scattered * metallic;
  surface.metal = metallic;
  surface.dielectric = dielectric;
  surface.slope = 1.0 - alpha2;
  surface.smith = vec2(1.0 - k, k);
  surface.gain = 0.25 * alpha2;
  return surface;
}
//! main
  Surface surface = surfaceOf(base.rgb, metallic, roughness);
