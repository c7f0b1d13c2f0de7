// SPDX-License-Identifier: MIT
// Linear light to a display of gamma 2.2.
//! functions
// c: linear light, 0 and up. Returns codes, 0-1.
vec3 linearToDisplay(vec3 c) {
  return pow(c, vec3(1.0 / 2.2));
}
