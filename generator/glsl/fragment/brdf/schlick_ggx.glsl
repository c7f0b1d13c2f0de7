// SPDX-License-Identifier: MIT
// V as a product.
//! functions
// nDotX: N.L or N.V. smith: 1 - k and k.
float shadowing(float nDotX, vec2 smith) {
  // The denominator of Schlick's G_1, N.X / (N.X (1 - k) + k): Karis, "Real Shading in Unreal Engine 4", 2013.
  // k = alpha / 2, and (roughness + 1)^2 / 8 for the BRDF `seed`.
  return smith.x * nDotX + smith.y;
}

// Returns pi D V; V = 0.25 / (shadowing(N.V) shadowing(N.L)).
float specularLobe(Angles angles, float nDotV, Surface surface) {
  float denominator = shadowing(nDotV, surface.smith) * denominatorD(angles, surface);
  denominator *= shadowing(angles.nDotL, surface.smith);
  return (angles.h2 * angles.h2) * (surface.gain * reciprocal(denominator));
}
