// The vertex shader's share of the angles.
//! declarations
varying vec3 vToCamera;
varying vec4 vVDotL;
varying vec4 vFresnel;
//! functions
// lightAngles of a light whose V.L and Fresnel term are given. reach: 1 + |V|^2, as V shrinks between vertices.
vec4 lightAngles(vec3 normal, float nDotV, float reach, vec3 toLight, float vDotL, float fresnel) {
  float nDotL = max(dot(normal, toLight), 0.0);
  float nDotH = nDotL + nDotV;
  return vec4(nDotL, nDotH * nDotH, 2.0 * vDotL + reach, fresnel);
}
//! main
  float reach = dot(vToCamera, vToCamera) + 1.000002;
  float nDotV = max(dot(normal, vToCamera), 1.0e-4);
