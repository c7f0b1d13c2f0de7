// SPDX-License-Identifier: MIT
// Light of the surface's own.
//! declarations
uniform vec3 uEmissive; // material: linear radiance
//! main
  color += uEmissive;
