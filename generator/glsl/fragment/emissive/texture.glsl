// SPDX-License-Identifier: MIT
// Light of the surface's own, from a texture.
//! declarations
uniform vec3 uEmissive; // material: linear radiance where the texture is white
uniform sampler2D uEmissiveTexture; // material: RGB, sRGB unless decode-none
//! main
  color += uEmissive * srgbToLinear(texture2D(uEmissiveTexture, ${uv}).rgb);
