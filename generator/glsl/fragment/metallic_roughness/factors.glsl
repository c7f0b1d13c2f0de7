// SPDX-License-Identifier: MIT
// The factors that the textures are multiplied with.
//! declarations
uniform vec2 uMetallicRoughness; // material: factors, 0-1
