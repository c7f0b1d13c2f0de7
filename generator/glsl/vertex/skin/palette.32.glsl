// SPDX-License-Identifier: MIT
// The joints of a skin: 32 at most.
//! declarations
uniform vec4 uJoints[96]; // skin: three rows of a matrix for each joint, from the bind pose to model space
