// SPDX-License-Identifier: MIT
// The base colour's texel, as it is stored.
//! declarations
uniform sampler2D uBaseColorTexture; // material: RGB, sRGB unless decode-none, alpha
//! main
  vec4 base = texture2D(uBaseColorTexture, ${uv});
