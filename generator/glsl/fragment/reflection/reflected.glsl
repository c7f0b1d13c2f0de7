// SPDX-License-Identifier: MIT
// What the surface reflects of the sky: scattered, reflected with the base colour's tint, and reflected without.
//! main
  vec3 specular = reflection * (share.tinted * base.rgb + share.untinted);
  vec3 color = specular + (irradiance * share.scattered) * base.rgb;
