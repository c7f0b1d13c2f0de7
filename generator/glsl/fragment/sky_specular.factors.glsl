// The sky's mirror image: what a lobe shows of it, and a lookup of how much is reflected, of which level, and which
// share of it is so broad that it is irradiance (specularLookup in specular_sky.h). The direction is bent towards
// N the more, the rougher the surface and the lower the eye: 2 N.V + bend (1 - N.V) of N (specularBend in pack.h).
//! declarations
uniform vec3 uReflectionLobe; // material: roughness; the bend, and 2 less that
uniform sampler2D uReflectionLookup; // frame: u is N.V, v roughness; F0's factor, the rest, level / 8, irradiance's share
//! main
  vec4 look = texture2D(uReflectionLookup, vec2(nDotV, uReflectionLobe.x));
  vec3 toSky = normal * (uReflectionLobe.z * nDotV + uReflectionLobe.y) - toCamera;
  vec3 mirrored = mix(skyThroughLobe(toSky, 8.0 * look.b), irradiance, look.a);
  vec3 skyShare = vec3(uReflectance.x, look.r * uReflectance.y, look.r * uReflectance.z + look.g);
