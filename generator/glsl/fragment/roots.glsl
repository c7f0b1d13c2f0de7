// Roots and reciprocals, by the instructions that the GPU has for them.
//! functions
float root(float x) {
  return sqrt(x);
}

float inverseRoot(float x) {
  return inversesqrt(x);
}

float inverse(float x) {
  return 1.0 / x;
}
