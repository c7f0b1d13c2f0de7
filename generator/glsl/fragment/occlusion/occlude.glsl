// SPDX-License-Identifier: MIT
// Occlusion dims ambient light only.
//! main
  irradiance *= occlusion;
