#version 100
// FrankenShader basecolor+sh+reflection+energy
//   baseColorTexture: 1
//   ambient: sh
//   reflection: 1
//   energy: 1
//
// FRAGMENT SHADER
//
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif

varying vec2 vUv0;
varying vec3 vNormal;
varying vec3 vToCamera;

uniform float uReflectionScale; // frame: root of the largest radiance that a texel can hold, times the exposure
uniform vec4 uBaseColor; // material: linear RGB and alpha
uniform vec4 uReflectance; // material: 0.96 (1 - metalness), metalness, 0.04 (1 - metalness), 1 - 0.04 (1 - metalness)
uniform vec3 uReflectionLobe; // material: roughness; the bend, and 2 less that

uniform sampler2D uBaseColorTexture; // material: RGB, sRGB unless decode-none, alpha
uniform sampler2D uReflectionTexture; // frame: RGBM, square-rooted
uniform sampler2D uReflectionLookup; // frame: by N.V and roughness: F_0's factor, rest, level / 8, irradiance's share

// The inverse of the sRGB transfer curve (IEC 61966-2-1). c: codes, 0-1. Returns linear light, 0-1.
vec3 srgbToLinear(vec3 c) {
  vec3 low = c * (1.0 / 12.92);
  vec3 high = pow(c * (1.0 / 1.055) + 0.055 / 1.055, vec3(2.4));
  return mix(high, low, step(c, vec3(0.04045)));
}

float inverseSquareRoot(float x) {
  return inversesqrt(x);
}

float reciprocal(float x) {
  return 1.0 / x;
}

// Two rectangles of an eighth of the atlas' width and height.
const vec2 kIrradianceUpper = vec2(0.8125, 0.75); // the middle of the upper half's: 13 / 16, 3 / 4
const vec2 kIrradianceLower = vec2(0.9375, 0.75); // the middle of the lower half's: 15 / 16, 3 / 4
const float kIrradianceHalf = 0.0546875; // half of what is not border: 7 / 8 / 16

// n: unit, world space. Returns irradiance over pi: the linear radiance of a white surface.
vec3 skyIrradiance(vec3 n) {
  // At (x, z) (1 - |y| / 2): any map that does not fold will do, and this one takes no reciprocal.
  float reach = kIrradianceHalf - 0.5 * kIrradianceHalf * abs(n.y);
  float u = n.y < 0.0 ? kIrradianceLower.x : kIrradianceUpper.x;
  vec4 texel = texture2D(uReflectionTexture, vec2(n.x * reach + u, n.z * reach + kIrradianceUpper.y));
  vec3 root = texel.rgb * (texel.a * uReflectionScale);
  return root * root;
}

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

struct View {
  vec3 normal; // N: unit, world space
  vec3 toCamera; // V: unit, world space
  float nDotV; // N.V, kept off 0, where visibility would divide by it
};

// normal: unit. toCamera: any length.
View viewOf(vec3 normal, vec3 toCamera) {
  vec3 v = toCamera * inverseSquareRoot(dot(toCamera, toCamera));
  return View(normal, v, max(dot(normal, v), 1.0e-4));
}

struct Share { // of the sky's light
  float scattered; // of the irradiance, tinted by the base colour
  float squared; // of the reflection, tinted twice: scattered between a metal's facets
  float tinted; // of the reflection, tinted by the base colour
  float untinted; // of the reflection
};

// The sRGB transfer curve (IEC 61966-2-1). c: linear light; clipped at 0 and 1. Returns codes, 0-1.
vec3 linearToDisplay(vec3 c) {
  c = clamp(c, 0.0, 1.0);
  vec3 high = 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055;
  return mix(high, 12.92 * c, step(c, vec3(0.0031308)));
}

void main() {
  vec4 base = texture2D(uBaseColorTexture, vUv0);
  base.rgb = srgbToLinear(base.rgb);
  base *= uBaseColor;

  vec3 normal = vNormal * inverseSquareRoot(dot(vNormal, vNormal));

  vec3 irradiance = skyIrradiance(normal);

  View view = viewOf(normal, vToCamera);

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
  vec3 specular = reflection * ((share.squared * base.rgb + share.tinted) * base.rgb + share.untinted);
  vec3 color = specular + (irradiance * share.scattered) * base.rgb;

  color = linearToDisplay(color);
  gl_FragColor = vec4(color, 1.0);
}
