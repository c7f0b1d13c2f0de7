// SPDX-License-Identifier: MIT
// Metals do not scatter the sky's light.
//! main
  irradiance *= uReflectance.x;
