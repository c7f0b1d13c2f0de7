// SPDX-License-Identifier: MIT
// The prefiltered sky, scaled by a lookup texture of the BRDF, which holds F_0's scale and bias, the level of the
// atlas, and a blend towards irradiance (reflectionLookup in reflection.h); with what is scattered between facets.
//! declarations
uniform sampler2D uReflectionLookup; // frame: by N.V and roughness: F_0's factor, rest, level / 8, irradiance's share
//! main
  // Bent towards N the more, the rougher the surface and the lower the eye, and a metal's more than a dielectric's
  // (reflectionBend in pack.h).
  float alpha = roughness * roughness;
  vec4 lookup = texture2D(uReflectionLookup, vec2(view.nDotV, roughness));
  float bend = (metallic + 0.6) * alpha;
  vec3 toSky = mix(bend, 2.0, view.nDotV) * view.normal - view.toCamera;
  Share share;
  share.scattered = 0.96 - 0.96 * metallic;
  // 1 / E - 1, as for lights (brdf/add_light.energy); E is F_0's factor and the rest, at least 0.306.
  float compensation = reciprocal(max(lookup.r + lookup.g, 0.25)) - 1.0;
  float dielectric = 0.04 - 0.04 * metallic;
  share.squared = metallic * (compensation * lookup.r);
  share.tinted = metallic * (compensation * lookup.g + lookup.r);
  share.untinted = (dielectric * lookup.r + lookup.g) * (dielectric * compensation + 1.0);
  vec3 reflection = mix(reflectedSky(toSky, 8.0 * lookup.b), irradiance, lookup.a);
