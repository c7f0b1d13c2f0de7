// SPDX-License-Identifier: MIT
// V without square roots.
//! functions
// The denominator of V = 0.5 / denominatorV; packMaterial and surfaceOf fold alpha^2 / 2 into it.
float denominatorV(Angles angles, float nDotV, Surface surface) {
  // Hammon, "PBR Diffuse Lighting for GGX+Smith Microsurfaces", 2017: mix(2 N.L N.V, N.L + N.V, alpha).
  return angles.nDotL * nDotV * surface.smith.x + (angles.nDotL + nDotV) * surface.smith.y;
}
