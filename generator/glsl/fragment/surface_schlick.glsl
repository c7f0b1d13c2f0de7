// Metalness and roughness by factor, folded by packMaterial.
//! declarations
uniform vec4 uLobe; // material: 1 - alpha^2, 1 - k, k, alpha^2 / 4
//! main
  Surface surface = Surface(uReflectance.x, uReflectance.y, uReflectance.z, uLobe.x, uLobe.yz, uLobe.w);
