// SPDX-License-Identifier: MIT
// The sum that lights are added to.
//! main
  Sum sum;
  sum.color = base.rgb * irradiance;
