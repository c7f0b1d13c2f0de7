// SPDX-License-Identifier: MIT
// The prefiltered sky, scaled by a lookup texture of the BRDF, which holds F_0's scale and bias, the level of the
// atlas, and a blend towards irradiance (reflectionLookup in reflection.h); with what is scattered between facets.
//! declarations
uniform vec3 uReflectionLobe; // material: roughness; the bend, and 2 less that
uniform sampler2D uReflectionLookup; // frame: by N.V and roughness: F_0's factor, rest, level / 8, irradiance's share
//! main
  // Bent towards N the more, the rougher the surface and the lower the eye: 2 N.V + bend (1 - N.V) of N
  // (reflectionBend in pack.h).
  vec3 toSky = view.normal * (uReflectionLobe.z * view.nDotV + uReflectionLobe.y) - view.toCamera;
  vec4 lookup = texture2D(uReflectionLookup, vec2(view.nDotV, uReflectionLobe.x));
  vec3 reflection = mix(reflectedSky(toSky, 8.0 * lookup.b), irradiance, lookup.a);
  Share share;
  share.scattered = uReflectance.x;
  // 1 / E - 1, as for lights (brdf/add_light.energy); E is F_0's factor and the rest, at least 0.306.
  float compensation = reciprocal(max(lookup.r + lookup.g, 0.25)) - 1.0;
  share.squared = uReflectance.y * (compensation * lookup.r);
  share.tinted = uReflectance.y * (compensation * lookup.g + lookup.r);
  share.untinted = (uReflectance.z * lookup.r + lookup.g) * (uReflectance.z * compensation + 1.0);
