// SPDX-License-Identifier: MIT
// A light whose vectors the vertex shader brought into tangent space.
//! functions
struct Light {
  vec3 direction; // L: towards the light, unit, tangent space
  vec3 radiance; // irradiance / pi
  vec3 halfVector; // H' = V + L
  float fresnel; // F: Schlick's (1 - V.H)^5
};

// (N.H')^2 and |H'|^2 come out times |N|^2, which cancels in the lobe.
Angles anglesOf(Light light, View view) {
  float nDotL = max(dot(view.normal, light.direction) * view.inverseN, 0.0);
  float nDotH = dot(view.normal, light.halfVector);
  float h2 = dot(view.normal, view.normal) * dot(light.halfVector, light.halfVector);
  return Angles(nDotL, nDotL, nDotH * nDotH, h2, light.fresnel);
}
