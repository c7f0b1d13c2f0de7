// SPDX-License-Identifier: MIT
// COLOR_0: linear, never decoded (glTF 2.0, 3.7.2.1).
//! declarations
attribute vec4 aColor;
varying vec4 vColor;
//! main
  vColor = aColor;
