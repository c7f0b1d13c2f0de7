// SPDX-License-Identifier: MIT
// Khronos PBR Neutral tone mapper, 2024: base colours below 0.8 come out as they went in, minus the
// 0.04 that Fresnel adds; highlights are compressed and lose saturation.
//! functions
// c: linear radiance, 0 and up. Returns 0-1.
vec3 toneMap(vec3 c) {
  float low = min(c.r, min(c.g, c.b));
  c = max(c - (low < 0.08 ? low - 6.25 * low * low : 0.04), 0.0);
  float peak = max(c.r, max(c.g, c.b));
  float over = max(peak - 0.76, 0.0);
  float compressed = over > 0.0 ? 1.0 - 0.0576 / (over + 0.24) : peak;
  float fade = 1.0 / (0.15 * (peak - compressed) + 1.0);
  return mix(vec3(compressed), c * (compressed / max(peak, 1.0e-4)), fade);
}
