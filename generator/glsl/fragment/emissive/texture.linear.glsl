// SPDX-License-Identifier: MIT
// Light of the surface's own, from a texture that is taken as linear.
//! declarations
uniform vec3 uEmissive; // material: linear radiance where the texture is white
uniform sampler2D uEmissiveTexture; // material: RGB, linear
//! main
  color += uEmissive * texture2D(uEmissiveTexture, ${uv}).rgb;
