// SPDX-License-Identifier: MIT
// Shares of the light that follow from the metalness factor, folded by packMaterial.
//! declarations
uniform vec4 uReflectance; // material: 0.96 (1 - metalness), metalness, 0.04 (1 - metalness), 1 - 0.04 (1 - metalness)
