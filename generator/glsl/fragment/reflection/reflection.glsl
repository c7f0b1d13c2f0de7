// SPDX-License-Identifier: MIT
// The prefiltered sky, scaled by a lookup texture of the BRDF, which holds F_0's scale and bias, the level of the
// atlas, and a blend towards irradiance (reflectionLookup in reflection.h).
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
  share.tinted = metallic * lookup.r;
  share.untinted = lookup.g + (0.04 - 0.04 * metallic) * lookup.r;
  vec3 reflection = mix(reflectedSky(toSky, 8.0 * lookup.b), irradiance, lookup.a);
