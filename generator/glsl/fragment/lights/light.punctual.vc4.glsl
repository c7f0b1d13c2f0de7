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
  float nDotL = max(dot(view.normal, light.direction) * light.inverseLength, 0.0);
  float nDotH = nDotL + view.nDotV;
  float h2 = dot(view.toCamera, light.direction) * light.inverseLength + 1.000001;
  h2 = h2 + h2; // a sum: VideoCore IV waits for its multiplier more than for its adder
  // squareRoot(0.25 * h2) with the quarter in the exponent, so that the lobe finds the same logarithm.
  float vDotH = exp2(0.50001 * log2(h2) - 1.0);
  return Angles(nDotL, nDotL * light.attenuation, nDotH * nDotH, h2, fresnel(vDotH));
}
