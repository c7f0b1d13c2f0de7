// SPDX-License-Identifier: MIT
// One sun's V.L.
//! declarations
uniform mediump vec3 u${light}Direction; // lights: towards the sun, unit, world space
//! main
  vVDotL.${lane} = dot(toCamera, u${light}Direction);
