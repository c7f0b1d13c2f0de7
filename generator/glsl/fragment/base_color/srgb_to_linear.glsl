// SPDX-License-Identifier: MIT
// The base colour's texel, to linear light.
//! main
  base.rgb = srgbToLinear(base.rgb);
