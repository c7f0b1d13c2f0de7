// SPDX-License-Identifier: MIT
// What is scattered between facets, for roughness by factor: packMaterial folds the roughness.
//! declarations
uniform vec4 uEnergy; // material: of log2 N.V, of the other logarithm, rest; alpha^2
//! functions
// Returns 1 / E - 1, with the share E of a white sky's light that leaves after one reflection.
float compensationOf(float nDotV, vec4 energy, float slope) {
  // A fit to the albedo of GGX with height-correlated Smith shadowing, within 0.8 % of 1 / E: generator/docs/energy.md.
  return exp2(energy.x * log2(nDotV) + energy.y * log2(nDotV * (slope * nDotV) + energy.w) + energy.z);
}
//! main
  surface.compensation = compensationOf(view.nDotV, uEnergy, uLobe.x);
