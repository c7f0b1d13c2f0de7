// SPDX-License-Identifier: MIT
// The reflection: what a lobe shows of the sky, and a lookup of how much is reflected, of which level, and which
// share of it is so broad that it is irradiance (reflectionLookup in reflection.h).
//! declarations
uniform sampler2D uReflectionLookup; // frame: by N.V and roughness: F_0's factor, rest, level / 8, irradiance's share
//! main
  // Bent towards N the more, the rougher the surface and the lower the eye, and a metal's more than a dielectric's
  // (reflectionBend in pack.h).
  float alpha = roughness * roughness;
  vec4 lookup = texture2D(uReflectionLookup, vec2(view.nDotV, roughness));
  float bend = (metallic + 0.6) * alpha;
  vec3 toSky = mix(bend, 2.0, view.nDotV) * view.normal - view.toCamera;
  Share share = Share(0.96 - 0.96 * metallic, metallic * lookup.r, lookup.g + (0.04 - 0.04 * metallic) * lookup.r);
  vec3 reflection = mix(reflectedSky(toSky, 8.0 * lookup.b), irradiance, lookup.a);
