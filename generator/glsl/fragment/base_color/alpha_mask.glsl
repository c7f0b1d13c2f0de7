// SPDX-License-Identifier: MIT
// Alpha test (glTF 2.0, alphaMode MASK).
//! declarations
uniform float uAlphaCutoff; // material: 0-1
//! main
  if (base.a < uAlphaCutoff) discard;
