// SPDX-License-Identifier: MIT
// What the surface reflects of the sky: scattered, mirrored with the base colour's tint, and mirrored without.
//! main
  vec3 mirrored = reflection * (share.tinted * base.rgb + share.untinted);
  vec3 color = mirrored + (irradiance * share.scattered) * base.rgb;
