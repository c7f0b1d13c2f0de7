// A reciprocal square root.
//! functions
float inverseRoot(float x) {
  return inversesqrt(x);
}
