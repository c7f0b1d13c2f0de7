// A reciprocal square root through exp2 and log2, for the reason that root.vc4.glsl gives. Not for vectors
// that lights make highlights with, which must be unit to more digits than this (generator/README.md).
//! functions
float inverseRoot(float x) {
  return exp2(-0.50001 * log2(x));
}
