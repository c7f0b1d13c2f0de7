// SPDX-License-Identifier: MIT
// A square root.
//! functions
float squareRoot(float x) {
  return sqrt(x);
}
