// SPDX-License-Identifier: MIT
// Texture times factor, both in sRGB codes. What the factor f does to linear light is linear in codes on the power part
// of the sRGB curve (IEC 61966-2-1), ((c + 0.055) / 1.055)^2.4: with k = f^(1/2.4), c becomes k c + 0.055 (k - 1). So
// an unlit texel needs neither decode nor encode; a factor of 1 leaves it as it is.
//! declarations
uniform vec3 uBaseColorEncoded[2]; // material: k, and 0.055 (k - 1)
//! main
  base.rgb = base.rgb * uBaseColorEncoded[0] + uBaseColorEncoded[1];
