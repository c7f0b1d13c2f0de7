// SPDX-License-Identifier: MIT
// Linear light to sRGB, within one code from code 10 up.
//! functions
// The power part of the sRGB curve alone: below code 10 it is too dark. c: linear light, 0 and up.
vec3 linearToDisplay(vec3 c) {
  return 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055;
}
