// The sky's mirror image: what a lobe shows of it, and a lookup of how much is reflected, of which level, and which
// share of it is so broad that it is irradiance (specularLookup in specular_sky.h). The direction is bent towards
// N the more, the rougher the surface and the lower the eye, and a metal's more than a dielectric's (specularBend in
// pack.h). Of equal forms and orders this one is among the shortest on vc4.
//! declarations
uniform sampler2D uReflectionLookup; // frame: u is N.V, v roughness; F0's factor, the rest, level / 8, irradiance's share
//! main
  float alpha = roughness * roughness;
  float bend = alpha * (0.6 + metallic);
  vec3 toSky = mix(bend, 2.0, nDotV) * normal - toCamera;
  vec4 look = texture2D(uReflectionLookup, vec2(nDotV, roughness));
  vec3 mirrored = mix(skyThroughLobe(toSky, 8.0 * look.b), irradiance, look.a);
  vec3 skyShare = vec3(0.96 - 0.96 * metallic, metallic * look.r, look.g + look.r * (0.04 - metallic * 0.04));
