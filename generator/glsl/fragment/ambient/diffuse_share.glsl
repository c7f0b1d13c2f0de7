// SPDX-License-Identifier: MIT
// Metals do not scatter the sky's light.
//! main
  irradiance *= 0.96 - 0.96 * metallic;
