#version 100
// FrankenShader basecolor.normal+ambient+sun1+energy
//   baseColorTexture: 1
//   normal: 1
//   ambient: ambient
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
varying vec3 vTangent;
varying vec3 vBitangent;

uniform vec3 uAmbient; // lights: linear radiance
uniform vec3 uSun0Direction; // lights: towards the sun, unit, world space
uniform vec3 uSun0Radiance; // lights: linear irradiance / pi
uniform vec4 uBaseColor; // material: linear RGB and alpha
uniform vec4 uReflectance; // material: 0.96 (1 - metalness), metalness, 0.04 (1 - metalness), 1 - 0.04 (1 - metalness)
uniform vec3 uLobe; // material: 1 - alpha^2, and the shadowing's coefficients
uniform vec4 uEnergy; // material: of log2 N.V, of the other logarithm, rest; alpha^2

uniform sampler2D uBaseColorTexture; // material: RGB, sRGB unless decode-none, alpha
uniform sampler2D uNormalTexture; // material: tangent space, +Y up the texture, linear

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

struct Sum {
  vec3 color; // linear radiance
};

struct View {
  vec3 normal; // N: any length, world space
  vec3 toCamera; // V: any length, world space
  float inverseN; // 1 / |N|
  float inverseV; // 1 / |V|
  float nDotV; // N.V of unit vectors, kept off 0, where visibility would divide by it
};

View viewOf(vec3 normal, vec3 toCamera) {
  float inverseN = inverseSquareRoot(dot(normal, normal));
  float inverseV = inverseSquareRoot(dot(toCamera, toCamera));
  float nDotV = max(dot(normal, toCamera) * (inverseV * inverseN), 1.0e-4);
  return View(normal, toCamera, inverseN, inverseV, nDotV);
}

struct Light {
  vec3 direction; // L: towards the light, unit, world space
  vec3 radiance; // irradiance / pi
};

Angles anglesOf(Light light, View view) {
  // With unit vectors |V + L|^2 = 2 + 2 V.L, and N.(V + L) = N.V + N.L: H' = V + L is never built.
  float nDotL = max(view.inverseN * dot(view.normal, light.direction), 0.0);
  float nDotH = nDotL + view.nDotV;
  float h2 = (dot(view.toCamera, light.direction) * view.inverseV) * 2.0 + 2.000002;
  return Angles(nDotL, nDotL, nDotH * nDotH, h2, fresnel(squareRoot(0.25 * h2)));
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

// Returns 1 / E - 1, with the share E of a white sky's light that leaves after one reflection.
float compensationOf(float nDotV, vec4 energy, float slope) {
  // A fit to the albedo of GGX with height-correlated Smith shadowing, within 0.8 % of 1 / E: generator/docs/energy.md.
  return exp2(energy.x * log2(nDotV) + energy.y * log2(nDotV * (slope * nDotV) + energy.w) + energy.z);
}

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

  vec3 texel = texture2D(uNormalTexture, vUv0).xyz - 0.5;
  vec3 normal = texel.x * vTangent + texel.y * vBitangent + texel.z * vNormal;

  Surface surface;
  surface.diffuse = uReflectance.x;
  surface.metal = uReflectance.y;
  surface.oneMinusF0 = uReflectance.w;
  surface.slope = uLobe.x;
  surface.smith = uLobe.yz;
  surface.gain = 1.0; // folded into surface.smith
  surface.base = base.rgb;

  vec3 irradiance = uAmbient;
  Sum sum;
  sum.color = base.rgb * irradiance;

  View view = viewOf(normal, vToCamera);

  surface.compensation = compensationOf(view.nDotV, uEnergy, uLobe.x);

  addLight(Light(uSun0Direction, uSun0Radiance), view, surface, sum);

  vec3 color = sum.color;

  color = linearToDisplay(color);
  gl_FragColor = vec4(color, 1.0);
}
