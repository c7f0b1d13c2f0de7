// SPDX-License-Identifier: MIT
// V as a product.
//! functions
// nDotX: N.L or N.V. smith: 1 - k and k.
float shadowing(float nDotX, vec2 smith) {
  // The denominator of Schlick's G_1, N.X / (N.X (1 - k) + k): Karis, "Real Shading in Unreal Engine 4", 2013.
  // k = alpha / 2, and (roughness + 1)^2 / 8 for the BRDF `seed`.
  return nDotX * smith.x + smith.y;
}

// Returns pi D V; V = 0.25 / (shadowing(N.V) shadowing(N.L)).
float specularLobe(Angles angles, float nDotV, Surface surface) {
  float denominator = denominatorD(angles, surface) * shadowing(nDotV, surface.smith);
  denominator *= shadowing(angles.nDotL, surface.smith);
  return surface.gain * reciprocal(denominator) * (angles.h2 * angles.h2);
}
