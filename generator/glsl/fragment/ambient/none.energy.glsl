// SPDX-License-Identifier: MIT
// No ambient light: the sum that lights are added to.
//! main
  Sum sum;
  sum.color = vec3(0.0);
