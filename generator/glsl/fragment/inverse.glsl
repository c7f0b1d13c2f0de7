// A reciprocal.
//! functions
float inverse(float x) {
  return 1.0 / x;
}
