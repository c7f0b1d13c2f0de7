// A square root.
//! functions
float root(float x) {
  return sqrt(x);
}
