// SPDX-License-Identifier: MIT
// A light, and its angles.
//! functions
struct Light {
  vec3 direction; // L: towards the light, unit, world space
  vec3 radiance; // irradiance / pi
};

Angles anglesOf(Light light, View view) {
  vec3 halfVector = view.toCamera + light.direction;
  vec3 crossed = cross(view.normal, halfVector);
  float h2 = max(dot(halfVector, halfVector), 0.01);
  float nDotL = max(dot(view.normal, light.direction), 0.0);
  float nDotH = nDotL + view.nDotV;
  return Angles(nDotL, nDotL, nDotH * nDotH, dot(crossed, crossed), h2, fresnel(squareRoot(0.25 * h2)));
}
