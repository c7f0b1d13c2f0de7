// SPDX-License-Identifier: MIT
// The sky itself. Texels hold sqrt(radiance / uSkyRange) as RGB times a shared alpha; they are scaled before they are
// squared, because their squares are too small for 16 bits.
//! declarations
uniform samplerCube uSkyTexture; // frame: RGBM, square-rooted
uniform float uSkyRange; // frame: the largest radiance that a texel can hold, times the exposure
//! main
  vec4 texel = textureCube(uSkyTexture, vDirection);
  vec3 color = texel.rgb * (texel.a * sqrt(uSkyRange));
  color *= color;
