// SPDX-License-Identifier: MIT
// The model matrix alone, where only the tangent asks for it.
//! declarations
uniform mat4 uModel; // object: model space to world space
