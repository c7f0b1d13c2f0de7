// SPDX-License-Identifier: MIT
// The normal map's normal, left in tangent space and not normalised. Texels hold 0.5 + 0.5 n.
//! declarations
uniform sampler2D uNormalTexture; // material: tangent space, +Y up the texture, linear
uniform float uNormalScale; // material: glTF's normalTexture.scale
//! main
  vec3 normal = texture2D(uNormalTexture, ${uv}).xyz - 0.5;
  normal.xy *= uNormalScale;
