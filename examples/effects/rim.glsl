// SPDX-License-Identifier: MIT
// A rim light: light where the surface turns away from the eye, as a lamp behind it would give.
//! declarations
uniform vec4 uRim; // user: linear colour, in the units of exposed light; exponent, 1 and up: the higher, the thinner
//! light
vec3 onLight(vec3 color, vec3 normal, vec3 toEye) {
  float facing = max(dot(normal, toEye) * inversesqrt(dot(toEye, toEye)), 0.0);
  return color + uRim.rgb * pow(1.0 - facing, uRim.w);
}
