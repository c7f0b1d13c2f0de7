// SPDX-License-Identifier: MIT
// Metalness and roughness by factor, folded by packMaterial.
//! declarations
uniform vec3 uLobe; // material: 1 - alpha^2, and the shadowing's coefficients
//! main
  vec4 shares = uReflectance;
  Surface surface = Surface(base.rgb, shares.x, shares.w, shares.y, shares.z, uLobe.x, uLobe.yz, 1.0);
