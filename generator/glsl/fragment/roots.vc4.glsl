// Roots and reciprocals through exp2 and log2: VideoCore IV's own rsq and rcp units are followed by a
// Newton step, its exp2 and log2 are not. The exponents are a trace off 1/2 and 1, or Mesa turns the
// expressions back; over 1e-6 to 10 that is 1.4e-4 of the result.
//! functions
float root(float x) {
  return exp2(0.50001 * log2(x));
}

float inverseRoot(float x) {
  return exp2(-0.50001 * log2(x));
}

float inverse(float x) {
  return exp2(-1.00001 * log2(x));
}
