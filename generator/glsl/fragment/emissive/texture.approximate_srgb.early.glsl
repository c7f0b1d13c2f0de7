// SPDX-License-Identifier: MIT
// Light of the surface's own, fetched before the lights are added: from a texture that is decoded as base_color/approximate_srgb_to_linear decodes.
//! declarations
uniform vec3 uEmissiveCubic[3]; // material: coefficients of c^3, c^2 and c, times the radiance of white
uniform sampler2D uEmissiveTexture; // material: RGB, sRGB unless decode-none
//! main
  vec3 glow = texture2D(uEmissiveTexture, ${uv}).rgb;
  sum.specular += glow * (glow * (glow * uEmissiveCubic[0] + uEmissiveCubic[1]) + uEmissiveCubic[2]);
