// SPDX-License-Identifier: MIT
// What a light needs to know of the surface, to tint what it reflects at once, and to keep what is scattered between
// facets.
//! functions
struct Surface {
  vec3 base; // linear base colour
  float diffuse; // 0.96 (1 - metalness): what a dielectric lets in and scatters
  float metal; // metalness
  float oneMinusF0; // 1 - 0.04 (1 - metalness), with F_0 of what the base colour does not tint
  float slope; // 1 - alpha^2, with alpha = roughness^2
  vec2 smith; // coefficients of the shadowing, by BRDF
  float gain; // the lobe's constant factor, where the shadowing's coefficients do not hold it
  float compensation; // 1 / E - 1, with the share E of a white sky's light that leaves after one reflection
};
