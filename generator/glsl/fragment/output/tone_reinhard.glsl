// SPDX-License-Identifier: MIT
// Reinhard et al., "Photographic Tone Reproduction for Digital Images", 2002, equation 3, per channel.
//! functions
// c: linear radiance, 0 and up. Returns 0-1.
vec3 toneMap(vec3 c) {
  return c / (c + 1.0);
}
