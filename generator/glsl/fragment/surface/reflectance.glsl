// SPDX-License-Identifier: MIT
// What follows from the metalness factor, folded by packMaterial. The last is what of the scattered light goes with the
// base colour (seed), or what is not mirrored without a tint.
//! declarations
uniform vec4 uReflectance; // material: scattered, metalness, 0.04 (1 - metalness), kept (seed) or 1 - the third
