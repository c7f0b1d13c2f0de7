// SPDX-License-Identifier: MIT
// Metalness and roughness by factor, folded by packMaterial.
//! declarations
uniform vec3 uLobe; // material: 1 - alpha^2, and the shadowing's coefficients
//! main
  Surface surface;
  surface.diffuse = uReflectance.x;
  surface.metal = uReflectance.y;
  surface.oneMinusF0 = uReflectance.w;
  surface.slope = uLobe.x;
  surface.smith = uLobe.yz;
  surface.gain = 1.0; // folded into surface.smith
