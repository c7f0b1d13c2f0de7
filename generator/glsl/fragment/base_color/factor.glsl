// SPDX-License-Identifier: MIT
// Base colour by factor alone.
//! declarations
uniform vec4 uBaseColor; // material: linear RGB and alpha
//! main
  vec4 base = uBaseColor;
