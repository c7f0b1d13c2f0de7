// Metalness and roughness by factor, folded by packMaterial.
//! declarations
uniform vec2 uLobe; // material: alpha^2, 1 - alpha^2
//! main
  Surface surface = Surface(uReflectance.x, uReflectance.y, uReflectance.z, uLobe.x, uLobe.y);
