// SPDX-License-Identifier: MIT
// A light, and its angles to vectors of any length.
//! functions
struct Light {
  vec3 direction; // L: towards the light, unit, world space
  vec3 radiance; // irradiance / pi
};

Angles anglesOf(Light light, View view) {
  // With unit vectors |V + L|^2 = 2 + 2 V.L, and N.(V + L) = N.V + N.L: H' = V + L is never built.
  float nDotL = max(view.inverseN * dot(view.normal, light.direction), 0.0);
  float nDotH = nDotL + view.nDotV;
  float h2 = (dot(view.toCamera, light.direction) * view.inverseV) * 2.0 + 2.000002;
  return Angles(nDotL, nDotL, nDotH * nDotH, h2, fresnel(squareRoot(0.25 * h2)));
}
