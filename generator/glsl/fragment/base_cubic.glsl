// The base colour's texel to linear light, by the cubic of decode_fast, times the factor, which is folded
// into the cubic's coefficients (packMaterial).
//! declarations
uniform vec3 uBaseColorCubic[3]; // material: coefficients of c^3, c^2 and c, times the factor
//! main
  base.rgb = base.rgb * (base.rgb * (base.rgb * uBaseColorCubic[0] + uBaseColorCubic[1]) + uBaseColorCubic[2]);
