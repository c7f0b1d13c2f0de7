// Metalness and roughness by factor, folded by packMaterial.
//! declarations
uniform vec3 uLobe; // material: 1 - alpha^2, and the shadowing's coefficients
//! main
  vec4 share = uReflectance;
  Surface surface = Surface(base.rgb, share.x, share.w, share.y, share.z, uLobe.x, uLobe.yz, 1.0);
