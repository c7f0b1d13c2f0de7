// SPDX-License-Identifier: MIT
// The reflection: what a lobe shows of the sky, and a lookup of how much is reflected, of which level, and which
// share of it is so broad that it is irradiance (reflectionLookup in reflection.h).
//! declarations
uniform vec3 uReflectionLobe; // material: roughness; the bend, and 2 less that
uniform sampler2D uReflectionLookup; // frame: by N.V and roughness: F_0's factor, rest, level / 8, irradiance's share
//! main
  // Bent towards N the more, the rougher the surface and the lower the eye: 2 N.V + bend (1 - N.V) of N
  // (reflectionBend in pack.h).
  vec3 toSky = view.normal * (uReflectionLobe.z * view.nDotV + uReflectionLobe.y) - view.toCamera;
  vec4 lookup = texture2D(uReflectionLookup, vec2(view.nDotV, uReflectionLobe.x));
  vec3 reflection = mix(reflectedSky(toSky, 8.0 * lookup.b), irradiance, lookup.a);
  Share share = Share(uReflectance.x, lookup.r * uReflectance.y, lookup.r * uReflectance.z + lookup.g);
