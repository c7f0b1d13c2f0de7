// SPDX-License-Identifier: MIT
// The sum that lights are added to.
//! main
  Sum sum;
  sum.diffuse = irradiance;
  sum.specular = vec3(0.0);
