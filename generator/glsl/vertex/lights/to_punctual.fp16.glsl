// SPDX-License-Identifier: MIT
// The vector to one punctual light. It is subtracted here, in 32 bits, and scaled so that the square of its length is a
// 16-bit float.
//! declarations
uniform vec4 u${light}Position; // lights: from the eye, world space, m; 1 / range^2
uniform float u${light}Scale; // lights: makes the farthest surface's distance 60 at most
varying vec3 vTo${light};
//! main
  vTo${light} = (u${light}Position.xyz + toCamera) * u${light}Scale;
