// SPDX-License-Identifier: MIT
// A light, and its angles.
//! functions
struct Light {
  vec3 direction; // L: towards the light, unit, world space
  vec3 radiance; // irradiance / pi
};

Angles anglesOf(Light light, View view) {
  // With unit vectors |V + L|^2 = 2 + 2 V.L, and N.(V + L) = N.V + N.L: H' = V + L is never built.
  float h2 = 2.0 * dot(view.toCamera, light.direction) + 2.000002;
  float schlick = fresnel(squareRoot(0.25 * h2)); // first: saves 3 instructions with four suns and the BRDF `seed`
  float nDotL = max(dot(view.normal, light.direction), 0.0);
  float nDotH = nDotL + view.nDotV;
  return Angles(nDotL, nDotL, nDotH * nDotH, h2, schlick);
}
