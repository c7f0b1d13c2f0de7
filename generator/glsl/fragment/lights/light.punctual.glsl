// SPDX-License-Identifier: MIT
// A light at any distance, and its angles. Its direction is not made unit: scaling two products is cheaper, and one
// inverse root serves them and the falloff.
//! functions
struct Light {
  vec3 direction; // towards the light, any length, world space
  vec3 radiance; // irradiance / pi where nothing attenuates it
  float inverseLength; // 1 / |direction|
  float attenuation; // by distance and cone
};

Angles anglesOf(Light light, View view) {
  // With unit vectors |V + L|^2 = 2 + 2 V.L, and N.(V + L) = N.V + N.L: H' = V + L is never built.
  float h2 = dot(view.toCamera, light.direction) * light.inverseLength * 2.0 + 2.000002;
  float nDotL = max(dot(view.normal, light.direction) * light.inverseLength, 0.0);
  float nDotH = nDotL + view.nDotV;
  return Angles(nDotL, nDotL * light.attenuation, nDotH * nDotH, h2, fresnel(squareRoot(0.25 * h2)));
}
