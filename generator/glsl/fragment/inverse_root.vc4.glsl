// A reciprocal square root through exp2 and log2, for the reason that root.vc4.glsl gives.
//! functions
float inverseRoot(float x) {
  return exp2(-0.50001 * log2(x));
}
