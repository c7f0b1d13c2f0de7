// SPDX-License-Identifier: MIT
// All light.
//! main
  color = sum.color;
