// SPDX-License-Identifier: MIT
// A square root through exp2 and log2.
//! functions
float squareRoot(float x) {
  // VideoCore IV's rsq unit is followed by a Newton step, its exp2 and log2 are not. The exponent is a trace off
  // 1/2, or Mesa turns the expression back; over 1e-6 to 10 that is 1.4e-4 of the result.
  return exp2(0.50001 * log2(x));
}
