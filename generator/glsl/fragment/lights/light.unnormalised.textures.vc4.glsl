// SPDX-License-Identifier: MIT
// A light, and its angles to vectors of any length.
//! functions
struct Light {
  vec3 direction; // L: towards the light, unit, world space
  vec3 radiance; // irradiance / pi
};

// (N.H')^2 and |H'|^2 come out times |N|^2, which cancels in the lobe.
Angles anglesOf(Light light, View view) {
  // |V + L|^2 = |V|^2 + 1 + 2 V.L, and N.(V + L) = N.V + N.L: H' = V + L is never built.
  float facingLight = max(dot(view.normal, light.direction), 0.0);
  float nDotH = facingLight + view.facing;
  float vDotL = dot(view.toCamera, light.direction) * view.inverseV;
  float h2 = (vDotL + view.v2) + vDotL;
  float nDotL = facingLight * view.inverseN;
  return Angles(nDotL, nDotL, nDotH * nDotH, view.n2 * h2, fresnel(squareRoot(0.25 * h2)));
}
