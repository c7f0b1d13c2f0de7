// SPDX-License-Identifier: MIT
// highp where the GPU has it; mediump is all that GLSL ES 1.00 promises in a fragment shader.
//! declarations
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif
