// SPDX-License-Identifier: MIT
// Metalness and roughness by factor, folded by packMaterial.
//! declarations
uniform vec3 uLobe; // material: 1 - alpha^2, and the shadowing's coefficients
//! main
  Surface surface = Surface(uReflectance.x, uReflectance.y, uReflectance.w, uLobe.x, uLobe.yz, 1.0);
