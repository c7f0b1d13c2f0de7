// SPDX-License-Identifier: MIT
// No light: the base colour is the picture.
//! main
  vec3 color = base.rgb;
