// SPDX-License-Identifier: MIT
// The normal map, out of tangent space, at any length. Texels hold 0.5 + 0.5 n.
//! declarations
uniform sampler2D uNormalTexture; // material: tangent space, +Y up the texture, linear
varying vec3 vTangent;
varying vec3 vBitangent;
//! main
  vec3 texel = texture2D(uNormalTexture, ${uv}).xyz - 0.5;
  vec3 normal = texel.x * vTangent + texel.y * vBitangent + texel.z * vNormal;
