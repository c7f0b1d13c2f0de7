// SPDX-License-Identifier: MIT
// What is scattered between facets, for roughness by texture.
//! functions
// roughness: 0-1. slope: 1 - alpha^2. Returns 1 / E - 1, with the share E of a white sky's light that leaves after one
// reflection.
float compensationOf(float nDotV, float roughness, float slope) {
  // A fit to the albedo of GGX with height-correlated Smith shadowing, within 1 % of 1 / E (generator/docs/energy.md).
  float r = max(roughness, 0.001);
  float root = squareRoot(nDotV * (slope * nDotV) + (1.0 - slope)); // Smith's; compilers find alpha^2 in it
  float wide = log2(root + 3.0 * (r * r));
  return exp2(8.3048 + 8.5239 * log2(r) + (0.7861 * log2(nDotV) + 0.1981 * nDotV) + (1.4195 * r - 5.0816) * wide);
}
//! main
  surface.compensation = compensationOf(view.nDotV, roughness, surface.slope);
