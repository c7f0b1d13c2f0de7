// Metalness and roughness by factor, folded by packMaterial.
//! declarations
uniform vec3 uLobe; // material: 1 - alpha^2, and the shadowing's coefficients
//! main
  vec3 scattered = uReflectance.x - uReflectance.w * base.rgb;
  Surface surface = Surface(scattered, uReflectance.y, uReflectance.z, uLobe.x, uLobe.yz, 1.0);
