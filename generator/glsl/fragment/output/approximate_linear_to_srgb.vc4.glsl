// SPDX-License-Identifier: MIT
// Linear light to sRGB, within one code from code 10 up. The curve's factor 1.055 is a summand of the exponent,
// because VideoCore IV waits for its multiplier more than for its adder.
//! functions
// The power part of the sRGB curve alone: below code 10 it is too dark. c: linear light, 0 and up.
vec3 linearToDisplay(vec3 c) {
  return exp2(log2(c) * (1.0 / 2.4) + 0.07724300) - 0.055;
}
