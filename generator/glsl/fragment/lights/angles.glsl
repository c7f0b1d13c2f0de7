// SPDX-License-Identifier: MIT
// What a light's direction means to a surface, for every BRDF. The half vector is never normalised: H' = V + L.
//! functions
struct Angles {
  float nDotL; // N.L, at least 0
  float arriving; // N.L, times what distance and cone leave of the light
  float nDotH2; // (N.H')^2
  float h2; // |H'|^2, kept off 0
  float fresnel; // F: Schlick's (1 - V.H)^5
};
