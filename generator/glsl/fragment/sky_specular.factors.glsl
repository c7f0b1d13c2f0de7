// The sky's mirror image: what a lobe shows of it, and a lookup of how much is reflected, from where, and which
// share of it is so broad that it is irradiance (specularLookup in specular_sky.h).
//! declarations
uniform vec3 uSpecularLobe; // material: roughness; the level over N.V, and at 0
uniform sampler2D uSpecularLookup; // frame: u is N.V, v roughness; F0's factor, the rest, bend, irradiance's share
//! main
  vec4 look = texture2D(uSpecularLookup, vec2(nDotV, uSpecularLobe.x));
  vec3 toSky = normal * ((2.0 * nDotV - 1.0) * look.b + 1.0) - toCamera * look.b;
  float level = max(nDotV * uSpecularLobe.y + uSpecularLobe.z, 0.0);
  vec3 mirrored = mix(skyThroughLobe(toSky, level) * uSpecularRange, irradiance, look.a);
  diffuse += mirrored * (look.r * uReflectance.y);
  specular += mirrored * (look.r * uReflectance.z + look.g);
