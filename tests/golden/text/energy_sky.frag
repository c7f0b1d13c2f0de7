#version 100
// FrankenShader basecolor.metalrough.occlusion-packed+sh+reflection+sun1+energy
//   baseColorTexture: 1
//   metallicRoughness: metalrough
//   occlusion: occlusion-packed
//   ambient: sh
//   reflection: 1
//   suns: sun1
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
uniform vec3 uSun0Direction; // lights: towards the sun, unit, world space
uniform vec3 uSun0Radiance; // lights: linear irradiance / pi
uniform vec4 uBaseColor; // material: linear RGB and alpha
uniform vec2 uMetallicRoughness; // material: factors, 0-1
uniform vec2 uOcclusion; // material: strength, 1 - strength

uniform sampler2D uBaseColorTexture; // material: RGB, sRGB unless decode-none, alpha
uniform sampler2D uMetallicRoughnessTexture; // material: linear
uniform sampler2D uReflectionTexture; // frame: RGBM, square-rooted
uniform sampler2D uReflectionLookup; // frame: by N.V and roughness: F_0's factor, rest, level / 8, irradiance's share

// The inverse of the sRGB transfer curve (IEC 61966-2-1). c: codes, 0-1. Returns linear light, 0-1.
vec3 srgbToLinear(vec3 c) {
  vec3 low = c * (1.0 / 12.92);
  vec3 high = pow(c * (1.0 / 1.055) + 0.055 / 1.055, vec3(2.4));
  return mix(high, low, step(c, vec3(0.04045)));
}

float squareRoot(float x) {
  return sqrt(x);
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

struct Surface {
  vec3 base; // linear base colour
  float diffuse; // 0.96 (1 - metalness): what a dielectric lets in and scatters
  float metal; // metalness
  float oneMinusF0; // 1 - 0.04 (1 - metalness), with F_0 of what the base colour does not tint
  float slope; // 1 - alpha^2, with alpha = roughness^2
  vec2 smith; // coefficients of the shadowing, by BRDF
  float gain; // the lobe's constant factor, where the shadowing's coefficients do not hold it
  float compensation; // 1 / E - 1, with the share E of a white sky's light that leaves after one reflection
};

struct Angles {
  float nDotL; // N.L, at least 0
  float arriving; // N.L, times what distance and cone leave of the light
  float nDotH2; // (N.H')^2
  float h2; // |H'|^2, kept off 0
  float fresnel; // F: Schlick's (1 - V.H)^5
};

// Returns what F_0 is not: F = F_0 + (1 - F_0) fresnel.
float fresnel(float vDotH) {
  // Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", 1994, equation 15.
  float x = 1.0 - vDotH;
  float x2 = x * x;
  return x2 * x2 * x;
}

// The denominator of pi D = alpha^2 |H'|^4 / denominatorD.
float denominatorD(Angles angles, Surface surface) {
  // GGX: Walter et al., "Microfacet Models for Refraction through Rough Surfaces", 2007, equation 33, with
  // (N.H)^2 = (N.H')^2 / |H'|^2.
  float d = angles.h2 - angles.nDotH2 * surface.slope;
  return d * d;
}

// The denominator of V = 0.5 / denominatorV; packMaterial and surfaceOf fold alpha^2 / 2 into it.
float denominatorV(Angles angles, float nDotV, Surface surface) {
  // Smith's shadowing, correlated by height: Heitz, "Understanding the Masking-Shadowing Function in
  // Microfacet-Based BRDFs", 2014, equation 99.
  float smithL = nDotV * squareRoot(angles.nDotL * (angles.nDotL * surface.smith.x) + surface.smith.y);
  float smithV = angles.nDotL * squareRoot(nDotV * (surface.smith.x * nDotV) + surface.smith.y);
  return smithV + smithL;
}

// Returns pi D V.
float specularLobe(Angles angles, float nDotV, Surface surface) {
  float denominator = denominatorV(angles, nDotV, surface) * denominatorD(angles, surface);
  return angles.h2 * angles.h2 * surface.gain * reciprocal(denominator);
}

// metallic, roughness: 0-1. The roughness is kept off 0, where a sun's highlight has no size.
Surface surfaceOf(float metallic, float roughness) {
  float r = max(roughness, 0.001);
  float alpha2 = (r * (r * r)) * r;
  Surface surface;
  surface.diffuse = 0.96 - 0.96 * metallic;
  surface.metal = metallic;
  surface.oneMinusF0 = 0.96 + 0.04 * metallic;
  surface.slope = 1.0 - alpha2;
  surface.smith = vec2(surface.slope, alpha2);
  surface.gain = 0.5 * alpha2;
  return surface;
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

struct Sum {
  vec3 color; // linear radiance
};

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

struct Light {
  vec3 direction; // L: towards the light, unit, world space
  vec3 radiance; // irradiance / pi
};

Angles anglesOf(Light light, View view) {
  // With unit vectors |V + L|^2 = 2 + 2 V.L, and N.(V + L) = N.V + N.L: H' = V + L is never built.
  float h2 = 2.0 * dot(view.toCamera, light.direction) + 2.000002;
  float schlick = fresnel(squareRoot(0.25 * h2)); // first: saves 3 instructions with four suns and the BRDF `seed`
  float nDotL = max(dot(view.normal, light.direction), 0.0);
  float nDotH = nDotL + view.nDotV;
  return Angles(nDotL, nDotL, nDotH * nDotH, h2, schlick);
}

void addLight(Light light, View view, Surface surface, inout Sum sum) {
  // glTF 2.0, appendix B: its mix of a dielectric and a metal, each times 1 + F_0 (1 / E - 1): Turquin, "Practical
  // multiple scattering compensation for microfacet models", 2019, equation 16. Sorted by powers of the base colour.
  Angles angles = anglesOf(light, view);
  float weightF90 = angles.arriving * angles.fresnel;
  float weightF0 = angles.arriving - weightF90;
  float specular = specularLobe(angles, view.nDotV, surface);
  float metal = surface.metal * specular;
  float metalF0 = metal * weightF0;
  float squared = surface.compensation * metalF0;
  float tinted = weightF0 * surface.diffuse + (metalF0 + surface.compensation * (metal * weightF90));
  float once = specular * (angles.arriving - weightF0 * surface.oneMinusF0);
  float untinted = once * (1.0 + surface.compensation - surface.compensation * surface.oneMinusF0);
  sum.color += (surface.base * (surface.base * squared + tinted) + untinted) * light.radiance;
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

  vec3 orm = texture2D(uMetallicRoughnessTexture, vUv0).rgb;
  float metallic = orm.b * uMetallicRoughness.x;
  float roughness = orm.g * uMetallicRoughness.y;

  vec3 irradiance = skyIrradiance(normal);

  Surface surface = surfaceOf(metallic, roughness);
  surface.base = base.rgb;

  View view = viewOf(normal, vToCamera);

  // Bent towards N the more, the rougher the surface and the lower the eye, and a metal's more than a dielectric's
  // (reflectionBend in pack.h).
  float alpha = roughness * roughness;
  vec4 lookup = texture2D(uReflectionLookup, vec2(view.nDotV, roughness));
  float bend = (metallic + 0.6) * alpha;
  vec3 toSky = mix(bend, 2.0, view.nDotV) * view.normal - view.toCamera;
  Share share;
  share.scattered = 0.96 - 0.96 * metallic;
  // 1 / E - 1, as for lights (brdf/add_light.energy); E is F_0's factor and the rest, at least 0.306.
  float compensation = reciprocal(max(lookup.r + lookup.g, 0.25)) - 1.0;
  float dielectric = 0.04 - 0.04 * metallic;
  share.squared = metallic * (compensation * lookup.r);
  share.tinted = metallic * (compensation * lookup.g + lookup.r);
  share.untinted = (dielectric * lookup.r + lookup.g) * (dielectric * compensation + 1.0);
  vec3 reflection = mix(reflectedSky(toSky, 8.0 * lookup.b), irradiance, lookup.a);

  float occlusion = orm.r * uOcclusion.x + uOcclusion.y;
  share.scattered *= occlusion;
  share.squared *= occlusion;
  share.tinted *= occlusion;
  share.untinted *= occlusion;

  vec3 specular = reflection * ((share.squared * base.rgb + share.tinted) * base.rgb + share.untinted);
  vec3 color = specular + (irradiance * share.scattered) * base.rgb;
  Sum sum;
  sum.color = color;

  surface.compensation = compensation;

  addLight(Light(uSun0Direction, uSun0Radiance), view, surface, sum);

  color = sum.color;

  color = linearToDisplay(color);
  gl_FragColor = vec4(color, 1.0);
}
