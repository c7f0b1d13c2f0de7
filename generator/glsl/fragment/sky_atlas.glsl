// The sky through lobes of rising width, in one texture: levels of two squares each, RGBM of the radiance's
// root (SpecularAtlas in specular_sky.h). Level i is as large as the first times 2^(-i / 2), and below the one
// before, so that all shrink towards one point: the numbers are that point and a square's place in the first level.
//! declarations
uniform sampler2D uReflectionTexture; // frame: RGBM, square-rooted
uniform float uReflectionScale; // frame: root of the largest radiance that a texel can hold, times the exposure
//! functions
// d: of any length. Returns where it lies in the first level, less the point that the levels shrink towards.
vec2 skyPoint(vec3 d) {
  vec3 a = abs(d);
  vec2 p = d.xz * inverse(max(a.x, a.z) + a.y);
  return vec2(p.x * 0.21875 + (d.y < 0.0 ? 0.75 : 0.25), p.y * 0.1340657 - 0.8930197);
}

// level: 0-8, of the roughness 2^((level - 8) / 2). Returns linear radiance.
vec3 skyThroughLobe(vec3 d, float level) {
  float whole = float(int(level));
  float size = exp2(-0.5 * whole);
  vec2 point = size * skyPoint(d);
  vec4 sharp = texture2D(uReflectionTexture, vec2(0.0, 1.0462376) + point);
  vec4 rough = texture2D(uReflectionTexture, vec2(0.0, 1.0462376) + 0.70710678 * point);
  float blend = uReflectionScale * (level - whole);
  vec3 root = rough.rgb * (rough.a * blend) + (sharp.a * (uReflectionScale - blend)) * sharp.rgb;
  return root * root;
}
