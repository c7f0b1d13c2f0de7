// SPDX-License-Identifier: MIT
// Fog: the farther a surface is, the less of its light arrives, and the more of the fog's own. Half of it is left after
// 1 / density metres (Beer-Lambert, with a half-value distance).
//! declarations
uniform vec4 uFog; // user: linear colour, in the units of exposed light; density, 1/m
//! light
vec3 onLight(vec3 color, vec3 toEye) {
  return mix(uFog.rgb, color, exp2(-uFog.w * length(toEye)));
}
