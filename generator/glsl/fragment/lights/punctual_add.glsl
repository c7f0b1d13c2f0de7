// SPDX-License-Identifier: MIT
// What the surface reflects of one punctual light.
//! main
  addLight(light${light}, view, surface, sum);
