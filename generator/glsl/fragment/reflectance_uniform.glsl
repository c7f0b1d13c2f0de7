// What follows from the metalness factor, folded by packMaterial.
//! declarations
uniform vec3 uReflectance; // material: 0.96 (1 - metalness), metalness, 0.04 (1 - metalness)
