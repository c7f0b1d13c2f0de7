// SPDX-License-Identifier: MIT
// Texture times factor.
//! declarations
uniform vec4 uBaseColor; // material: linear RGB and alpha
//! main
  base *= uBaseColor;
