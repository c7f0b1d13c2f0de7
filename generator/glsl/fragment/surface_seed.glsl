// Metalness and roughness by factor, folded by packMaterial.
//! declarations
uniform vec4 uLobe; // material: 1 - alpha^2, 1 - k, k, alpha^2 / 4
//! functions
// reflectance: see uReflectance. The specular layer takes its share from each channel of the base colour.
vec3 scattered(vec3 base, vec3 reflectance) {
  return (1.0 - reflectance.y) * (1.0 - reflectance.z - reflectance.y * base);
}
//! main
  vec3 diffuseShare = scattered(base.rgb, uReflectance);
  Surface surface = Surface(diffuseShare, uReflectance.y, uReflectance.z, uLobe.x, uLobe.yz, uLobe.w);
