// SPDX-License-Identifier: MIT
// What is scattered between facets, for roughness by texture. surface.slope holds alpha^2 here: surface/slope.fp16.
//! functions
// roughness: 0.3-1. alpha2: roughness^4. Returns 1 / E - 1, with the share E of a white sky's light that leaves after
// one reflection.
float compensationOf(float nDotV, float roughness, float alpha2) {
  // A fit to the albedo of GGX with height-correlated Smith shadowing, within 1 % of 1 / E (generator/docs/energy.md).
  float root = squareRoot(nDotV * nDotV * (1.0 - alpha2) + alpha2); // Smith's
  float wide = log2(root + 3.0 * (roughness * roughness));
  float narrow = 0.7861 * log2(nDotV) + 0.1981 * nDotV;
  return exp2(8.3048 + 8.5239 * log2(roughness) + narrow + (1.4195 * roughness - 5.0816) * wide);
}
//! main
  surface.compensation = compensationOf(view.nDotV, roughness, surface.slope);
