// SPDX-License-Identifier: MIT
// What the surface reflects of the sky: scattered, and reflected with the base colour's tint twice, once or not at all.
//! main
  vec3 specular = reflection * ((share.squared * base.rgb + share.tinted) * base.rgb + share.untinted);
  vec3 color = specular + (irradiance * share.scattered) * base.rgb;
