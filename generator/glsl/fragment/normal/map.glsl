// SPDX-License-Identifier: MIT
// The normal map, out of tangent space. Texels hold 0.5 + 0.5 n; as the result is normalised, 0.5 n does.
//! declarations
uniform sampler2D uNormalTexture; // material: tangent space, +Y up the texture, linear
varying vec3 vTangent;
varying vec3 vBitangent;
//! functions
// texel: as stored. The frame's axes may have any length; x and y carry the map's scale.
vec3 mapNormal(vec3 texel, vec3 tangent, vec3 bitangent, vec3 normal) {
  vec3 n = texel - 0.5;
  n = n.x * tangent + n.y * bitangent + n.z * normal;
  return n * inverseSquareRoot(dot(n, n));
}
//! main
  vec3 normal = mapNormal(texture2D(uNormalTexture, ${uv}).xyz, vTangent, vBitangent, vNormal);
