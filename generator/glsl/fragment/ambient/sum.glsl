// SPDX-License-Identifier: MIT
// The sum that lights are added to.
//! main
  Sum sum = Sum(irradiance, vec3(0.0));
