// SPDX-License-Identifier: MIT
// V as a product.
//! functions
// nDotX: N.L or N.V. smith: 1 - k and k.
float shadowing(float nDotX, vec2 smith) {
  // The denominator of Schlick's G_1, N.X / (N.X (1 - k) + k): Karis, "Real Shading in Unreal Engine 4", 2013.
  // k = alpha / 2, and (roughness + 1)^2 / 8 for the BRDF `seed`.
  return smith.x * nDotX + smith.y;
}

// The denominator of V = 0.25 / denominatorV; packMaterial and surfaceOf fold alpha^2 / 4 into it.
float denominatorV(Angles angles, float nDotV, Surface surface) {
  return shadowing(nDotV, surface.smith) * shadowing(angles.nDotL, surface.smith);
}
