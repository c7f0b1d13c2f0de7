// SPDX-License-Identifier: MIT
// A light whose angle to the eye came from the vertex shader.
//! declarations
varying vec3 vToCamera;
varying vec4 vVDotL;
varying vec4 vFresnel;
//! functions
struct Light {
  vec3 direction; // L: towards the light, unit, world space
  vec3 radiance; // irradiance / pi
  float vDotL; // V.L
  float fresnel; // F: Schlick's (1 - V.H)^5
};

Angles anglesOf(Light light, View view) {
  // |V + L|^2 = |V|^2 + 1 + 2 V.L, and N.(V + L) = N.V + N.L: H' = V + L is never built.
  float nDotL = max(dot(view.normal, light.direction), 0.0);
  float nDotH = nDotL + view.nDotV;
  return Angles(nDotL, nDotL, nDotH * nDotH, 2.0 * light.vDotL + view.v2, light.fresnel);
}
