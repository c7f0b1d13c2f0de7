// SPDX-License-Identifier: MIT
// A reciprocal square root through exp2 and log2. Not for vectors that lights make highlights with, which must be
// unit to more digits than this (generator/docs/mathematics.md, Roots on VideoCore IV).
//! functions
float inverseSquareRoot(float x) {
  // Without the Newton step that follows VideoCore IV's rsq unit; a trace off 1/2, or Mesa turns it back.
  return exp2(-0.50001 * log2(x));
}
