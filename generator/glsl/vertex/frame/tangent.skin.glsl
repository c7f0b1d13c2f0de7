// SPDX-License-Identifier: MIT
// The tangent in world space, turned by the joints. A zero-length one stays zero instead of becoming NaN: the
// normal map is then flat in that direction.
//! declarations
attribute vec4 aTangent; // xyz: direction of +U; w: +1 or -1, the bitangent's side
//! functions
vec3 safeNormalize(vec3 v) {
  return v * inversesqrt(max(dot(v, v), 1.0e-12));
}
//! main
  vec3 skinnedTangent = vec3(dot(skinX.xyz, aTangent.xyz), dot(skinY.xyz, aTangent.xyz), dot(skinZ.xyz, aTangent.xyz));
  vec3 tangent = safeNormalize((uModel * vec4(skinnedTangent, 0.0)).xyz);
