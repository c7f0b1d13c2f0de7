// SPDX-License-Identifier: MIT
// The sky itself. Texels hold sqrt(radiance / uSkyRange) as RGB times a shared alpha.
//! declarations
uniform samplerCube uSkyTexture; // frame: RGBM, square-rooted
uniform float uSkyRange; // frame: the largest radiance that a texel can hold, times the exposure
//! main
  vec4 texel = textureCube(uSkyTexture, vDirection);
  vec3 color = texel.rgb * texel.a;
  color *= color * uSkyRange;
