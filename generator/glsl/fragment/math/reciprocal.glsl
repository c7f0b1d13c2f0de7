// SPDX-License-Identifier: MIT
// A reciprocal.
//! functions
float reciprocal(float x) {
  return 1.0 / x;
}
