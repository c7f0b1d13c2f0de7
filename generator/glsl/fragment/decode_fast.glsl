// sRGB to linear light, by a cubic: no exp2 and no log2.
//! functions
// A cubic through (0, 0) and (1, 1), fitted to the sRGB curve. c: codes, 0-1. Returns linear light, 0-1.
vec3 decodeSrgb(vec3 c) {
  return c * (c * (c * 0.305306011 + 0.682171111) + 0.012522878);
}
