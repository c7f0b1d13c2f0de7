#version 100
// FrankenShader basecolor.normal.occlusion+sh+reflection+sun2+vertexlight
//   baseColorTexture: 1
//   normal: 1
//   occlusion: occlusion
//   ambient: sh
//   reflection: 1
//   suns: sun2
//   lightVectors: 1
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
varying vec3 vTangent;
varying vec3 vBitangent;
varying vec3 vToCamera;
varying vec4 vVDotL;
varying vec4 vFresnel;

uniform float uReflectionScale; // frame: root of the largest radiance that a texel can hold, times the exposure
uniform mediump vec3 uSun0Direction; // lights: towards the sun, unit, world space
uniform vec3 uSun0Radiance; // lights: linear irradiance / pi
uniform mediump vec3 uSun1Direction; // lights: towards the sun, unit, world space
uniform vec3 uSun1Radiance; // lights: linear irradiance / pi
uniform vec4 uBaseColor; // material: linear RGB and alpha
uniform vec2 uOcclusion; // material: strength, 1 - strength
uniform vec4 uReflectance; // material: 0.96 (1 - metalness), metalness, 0.04 (1 - metalness), 1 - 0.04 (1 - metalness)
uniform vec3 uLobe; // material: 1 - alpha^2, and the shadowing's coefficients
uniform vec3 uReflectionLobe; // material: roughness; the bend, and 2 less that

uniform sampler2D uBaseColorTexture; // material: RGB, sRGB unless decode-none, alpha
uniform sampler2D uNormalTexture; // material: tangent space, +Y up the texture, linear
uniform sampler2D uOcclusionTexture; // material: R, linear
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

// texel: as stored. The frame's axes may have any length; x and y carry the map's scale.
vec3 mapNormal(vec3 texel, vec3 tangent, vec3 bitangent, vec3 normal) {
  vec3 n = texel - 0.5;
  n = n.x * tangent + n.y * bitangent + n.z * normal;
  return n * inverseSquareRoot(dot(n, n));
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
};

struct Angles {
  float nDotL; // N.L, at least 0
  float arriving; // N.L, times what distance and cone leave of the light
  float nDotH2; // (N.H')^2
  float h2; // |H'|^2, kept off 0
  float fresnel; // F: Schlick's (1 - V.H)^5
};

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
  vec3 toCamera; // V: unit but for what shrinks between vertices, world space
  float nDotV; // N.V, kept off 0, where visibility would divide by it
  float v2; // 1 + |V|^2, kept off 2
};

struct Light {
  vec3 direction; // L: towards the light, unit, world space
  vec3 radiance; // irradiance / pi
  float vDotL; // V.L
  float fresnel; // F: Schlick's (1 - V.H)^5
};

Angles anglesOf(Light light, View view) {
  // |V + L|^2 = |V|^2 + 1 + 2 V.L, and N.(V + L) = N.V + N.L: H' = V + L is never built.
  float nDotL = max(dot(view.normal, light.direction), 0.0);
  float nDotH = nDotL + view.nDotV;
  return Angles(nDotL, nDotL, nDotH * nDotH, 2.0 * light.vDotL + view.v2, light.fresnel);
}

void addLight(Light light, View view, Surface surface, inout Sum sum) {
  // glTF 2.0, appendix B: its mix of a dielectric and a metal, sorted by what the base colour tints. Schlick's F is
  // F_0 (1 - x^5) + F_90 x^5, and F_90 is 1, which nothing tints.
  Angles angles = anglesOf(light, view);
  float weightF0 = angles.arriving - angles.arriving * angles.fresnel;
  float specular = specularLobe(angles, view.nDotV, surface);
  float tinted = weightF0 * (surface.diffuse + surface.metal * specular);
  float untinted = (angles.arriving - weightF0 * surface.oneMinusF0) * specular;
  sum.color += (surface.base * tinted + untinted) * light.radiance;
}

struct Share { // of the sky's light
  float scattered; // of the irradiance, tinted by the base colour
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

  vec3 normal = mapNormal(texture2D(uNormalTexture, vUv0).xyz, vTangent, vBitangent, vNormal);

  float occlusion = texture2D(uOcclusionTexture, vUv0).r * uOcclusion.x + uOcclusion.y;

  vec3 irradiance = skyIrradiance(normal);

  Surface surface;
  surface.diffuse = uReflectance.x;
  surface.metal = uReflectance.y;
  surface.oneMinusF0 = uReflectance.w;
  surface.slope = uLobe.x;
  surface.smith = uLobe.yz;
  surface.gain = 1.0; // folded into surface.smith
  surface.base = base.rgb;

  float nDotV = max(dot(normal, vToCamera), 1.0e-4);
  View view = View(normal, vToCamera, nDotV, dot(vToCamera, vToCamera) + 1.000002);

  // Bent towards N the more, the rougher the surface and the lower the eye: 2 N.V + bend (1 - N.V) of N
  // (reflectionBend in pack.h).
  vec3 toSky = view.normal * (uReflectionLobe.z * view.nDotV + uReflectionLobe.y) - view.toCamera;
  vec4 lookup = texture2D(uReflectionLookup, vec2(view.nDotV, uReflectionLobe.x));
  vec3 reflection = mix(reflectedSky(toSky, 8.0 * lookup.b), irradiance, lookup.a);
  Share share;
  share.scattered = uReflectance.x;
  share.tinted = lookup.r * uReflectance.y;
  share.untinted = lookup.r * uReflectance.z + lookup.g;

  share.scattered *= occlusion;
  share.tinted *= occlusion;
  share.untinted *= occlusion;

  vec3 specular = reflection * (share.tinted * base.rgb + share.untinted);
  vec3 color = specular + (irradiance * share.scattered) * base.rgb;
  Sum sum;
  sum.color = color;

  addLight(Light(uSun0Direction, uSun0Radiance, vVDotL.x, vFresnel.x), view, surface, sum);
  addLight(Light(uSun1Direction, uSun1Radiance, vVDotL.y, vFresnel.y), view, surface, sum);

  color = sum.color;

  color = linearToDisplay(color);
  gl_FragColor = vec4(color, 1.0);
}
