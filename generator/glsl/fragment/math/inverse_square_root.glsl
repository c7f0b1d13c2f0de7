// SPDX-License-Identifier: MIT
// A reciprocal square root.
//! functions
float inverseSquareRoot(float x) {
  return inversesqrt(x);
}
