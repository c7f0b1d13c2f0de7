// SPDX-License-Identifier: MIT
// What a light needs to know of the surface; the specular layer takes its share from each channel of the
// base colour, so that what is scattered is `diffuse` - `tinted` base.
//! functions
struct Surface {
  vec3 base; // linear base colour
  float diffuse; // (1 - metalness) (1 - 0.04 (1 - metalness))
  float tinted; // (1 - metalness) metalness
  float metal; // metalness
  float dielectric; // 0.04 (1 - metalness)
  float slope; // 1 - alpha^2, with alpha = roughness^2
  vec2 smith; // coefficients of the shadowing
  float gain; // the lobe's constant factor, where the shadowing's coefficients do not hold it
};
