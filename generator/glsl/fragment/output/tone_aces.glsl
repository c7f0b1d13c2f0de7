// SPDX-License-Identifier: MIT
// Narkowicz, "ACES Filmic Tone Mapping Curve", 2016: a fit of ACES' reference and output transforms for
// an sRGB display.
//! functions
// c: linear radiance, 0 and up. Returns 0-1, and slightly above for the brightest.
vec3 toneMap(vec3 c) {
  return c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14);
}
