// SPDX-License-Identifier: MIT
// The specular lobe, its quotient as a difference of logarithms: three products fewer, two sums more. On VideoCore IV
// products are scarcer, and |H'|^2 has its logarithm already where its root is taken.
//! functions
// Returns pi D V.
float specularLobe(Angles angles, float nDotV, Surface surface) {
  float denominator = denominatorV(angles, nDotV, surface) * denominatorD(angles, surface);
  float h = log2(angles.h2); // a product less than a reciprocal, and lights/light.vc4 has taken it already
  return surface.gain * exp2((h + h) - log2(denominator));
}
