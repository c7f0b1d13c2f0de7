// The sky's mirror image: what a lobe shows of it, and a lookup of how much is reflected, from where, and which
// share of it is so broad that it is irradiance (specularLookup in specular_sky.h).
//! declarations
uniform sampler2D uSpecularLookup; // frame: u is N.V, v roughness; F0's factor, the rest, bend, irradiance's share
//! main
  vec4 look = texture2D(uSpecularLookup, vec2(nDotV, roughness));
  vec3 toSky = normal * ((2.0 * nDotV - 1.0) * look.b + 1.0) - toCamera * look.b;
  float level = max(2.0 * log2(max(roughness, 0.001)) + (nDotV - 1.0) * (2.5 - 2.5 * roughness) + 8.0, 0.0);
  vec3 mirrored = mix(skyThroughLobe(toSky, level) * uSpecularRange, irradiance, look.a);
  diffuse += mirrored * (look.r * metallic);
  specular += mirrored * (look.r * (0.04 - 0.04 * metallic) + look.g);
