// Angles in tangent space, from vectors that the vertex shader brought there.
//! functions
// normal: any length; the scale that it brings into (N.H)^2 and |H|^2 cancels in the BRDF.
vec4 lightAngles(vec3 normal, float inverseLength, vec4 toLight, vec3 halfVector) {
  float nDotL = max(dot(normal, toLight.xyz) * inverseLength, 0.0);
  float nDotH = dot(normal, halfVector);
  return vec4(nDotL, nDotH * nDotH, dot(normal, normal) * dot(halfVector, halfVector), toLight.w);
}
//! main
  float inverseLength = inverseRoot(dot(normal, normal));
  float nDotV = max((dot(normal, vHalfSun0) - dot(normal, vToSun0.xyz)) * inverseLength, 1.0e-4);
