// What follows from the metalness factor, folded by packMaterial.
//! declarations
uniform vec4 uReflectance; // material: scattered, metalness, 0.04 (1 - metalness), what of scattered goes with the base, or 1 - 0.04 (1 - metalness)
