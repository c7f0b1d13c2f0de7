// SPDX-License-Identifier: MIT
// D.
//! functions
// The denominator d of pi D = alpha^2 |H'|^4 / d^2. surface.slope holds alpha^2 here: surface/slope.fp16.
float denominatorD(Angles angles, Surface surface) {
  // GGX: Walter et al., "Microfacet Models for Refraction through Rough Surfaces", 2007, equation 33. Its
  // |H'|^2 - (N.H')^2 is |N x H'|^2 by Lagrange's identity: as a difference it would have too few digits.
  return angles.nDotH2 * surface.slope + angles.sine2;
}
