// SPDX-License-Identifier: MIT
// Alpha: texture times factor.
//! declarations
uniform vec4 uBaseColor; // material: linear RGB and alpha
//! main
  base.a *= uBaseColor.a;
