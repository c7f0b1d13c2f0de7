// SPDX-License-Identifier: MIT
// The specular lobe, in an order that neither overflows nor becomes 0 / 0 from roughness 0.3 up.
//! functions
// Returns pi D V, at most 500: what is brighter is white in any light.
float specularLobe(Angles angles, float nDotV, Surface surface) {
  float peak = angles.h2 * reciprocal(denominatorD(angles, surface)); // 1 to 1 / alpha^2
  return min((surface.gain * peak) * peak * reciprocal(denominatorV(angles, nDotV, surface)), 500.0);
}
