// SPDX-License-Identifier: MIT
// The sky through lobes of rising width, in one texture: levels of two squares each, RGBM of the radiance's root
// (ReflectionAtlas in reflection.h).
//! declarations
uniform sampler2D uReflectionTexture; // frame: RGBM, square-rooted
uniform float uReflectionScale; // frame: root of the largest radiance that a texel can hold, times the exposure
//! functions
// Nine levels of two squares, each sqrt(1/2) of the one before in size and below it: all shrink towards one point.
const float kAtlasPoint = 1.0462376; // v of that point, at u = 0: 1 / (1 - 2^(-9/2))
const vec2 kAtlasHalf = vec2(0.25, 0.153218); // half a square of level 0: 1 / 4; 0.5 (1 - sqrt(1/2)) / (1 - 2^(-9/2))
const float kAtlasNext = 0.70710678; // a level's size to that of the one before: sqrt(1/2)
const float kAtlasInner = 0.875; // what is not a square's border: 7 / 8

// d: of any length. Returns where it lies in level 0, less the point that the levels shrink towards.
vec2 atlasPoint(vec3 d) {
  vec3 a = abs(d);
  vec2 p = d.xz * reciprocal(max(a.x, a.z) + a.y);
  vec2 middle = vec2(d.y < 0.0 ? 3.0 * kAtlasHalf.x : kAtlasHalf.x, kAtlasHalf.y - kAtlasPoint);
  return p * (kAtlasInner * kAtlasHalf) + middle;
}

// d: of any length. level: 0-8, of the roughness 2^((level - 8) / 2). Returns linear radiance.
vec3 reflectedSky(vec3 d, float level) {
  float whole = float(int(level));
  vec2 point = exp2(-0.5 * whole) * atlasPoint(d);
  vec4 sharp = texture2D(uReflectionTexture, vec2(0.0, kAtlasPoint) + point);
  vec4 rough = texture2D(uReflectionTexture, vec2(0.0, kAtlasPoint) + kAtlasNext * point);
  // Mixed before the root is squared, and the scale taken by the weights: fewer products than to decode first.
  float blend = uReflectionScale * (level - whole);
  vec3 root = rough.rgb * (rough.a * blend) + (sharp.a * (uReflectionScale - blend)) * sharp.rgb;
  return root * root;
}
