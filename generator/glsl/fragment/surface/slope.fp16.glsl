// SPDX-License-Identifier: MIT
// What the lobe takes of alpha.
//! main
  surface.slope = (roughness * roughness) * (roughness * roughness); // alpha^2: 1 - alpha^2 has too few digits
