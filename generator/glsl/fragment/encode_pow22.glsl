// Linear light to a display of gamma 2.2.
//! functions
// c: linear light; clipped at 0. Returns codes, 0-1.
vec3 encodeDisplay(vec3 c) {
  return pow(max(c, 0.0), vec3(1.0 / 2.2));
}
