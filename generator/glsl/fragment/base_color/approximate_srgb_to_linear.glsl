// SPDX-License-Identifier: MIT
// The base colour's texel to linear light, by a cubic through (0, 0) and (1, 1) that was fitted to the sRGB curve: no
// exp2 and no log2. The factor is folded into its coefficients (packMaterial).
//! declarations
uniform vec3 uBaseColorCubic[3]; // material: coefficients of c^3, c^2 and c, times the factor
//! main
  base.rgb = base.rgb * (base.rgb * (base.rgb * uBaseColorCubic[0] + uBaseColorCubic[1]) + uBaseColorCubic[2]);
