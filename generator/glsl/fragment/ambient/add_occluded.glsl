// SPDX-License-Identifier: MIT
// Ambient light after the suns; occlusion dims it alone.
//! main
  sum.diffuse += irradiance * occlusion;
