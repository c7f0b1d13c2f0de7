// The sky's mirror image: what a lobe shows of it, and a lookup of how much is reflected, of which level, and which
// share of it is so broad that it is irradiance (specularLookup in specular_sky.h). The direction is bent towards
// N the more, the rougher the surface (specularBend in pack.h).
//! declarations
uniform sampler2D uSpecularLookup; // frame: u is N.V, v roughness; F0's factor, the rest, level / 8, irradiance's share
//! main
  vec4 look = texture2D(uSpecularLookup, vec2(nDotV, roughness));
  vec3 skyShare = vec3(0.96 - metallic * 0.96, metallic * look.r, (0.04 - metallic * 0.04) * look.r + look.g);
  float alpha = roughness * roughness;
  float alpha2 = alpha * alpha;
  vec3 toSky = (2.0 * nDotV + (alpha * 0.8 + (alpha2 * alpha2) * 7.0)) * normal - toCamera;
  vec3 mirrored = mix(skyThroughLobe(toSky, look.b * 8.0), irradiance, look.a);
