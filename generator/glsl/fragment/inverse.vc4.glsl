// A reciprocal through exp2 and log2, for the reason that root.vc4.glsl gives.
//! functions
float inverse(float x) {
  return exp2(-1.00001 * log2(x));
}
