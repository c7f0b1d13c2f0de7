// A square root through exp2 and log2: VideoCore IV's own rsq unit is followed by a Newton step, its exp2
// and log2 are not. The exponent is a trace off 1/2, or Mesa turns the expression back; over 1e-6 to 10
// that is 1.4e-4 of the result.
//! functions
float root(float x) {
  return exp2(0.50001 * log2(x));
}
