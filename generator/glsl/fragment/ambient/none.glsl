// SPDX-License-Identifier: MIT
// No ambient light: the sum that lights are added to.
//! main
  Sum sum;
  sum.diffuse = vec3(0.0);
  sum.specular = vec3(0.0);
