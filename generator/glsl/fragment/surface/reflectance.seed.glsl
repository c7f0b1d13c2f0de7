// SPDX-License-Identifier: MIT
// Shares of the light that follow from the metalness factor, folded by packMaterial. The fields are those of Surface.
//! declarations
uniform vec4 uReflectance; // material: diffuse, metalness, 0.04 (1 - metalness), tinted
