// SPDX-License-Identifier: MIT
// Back faces are lit from their own side (glTF 2.0, doubleSided).
//! main
  if (!gl_FrontFacing) normal = -normal;
