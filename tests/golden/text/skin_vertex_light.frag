#version 100
// FrankenShader basecolor.normal+ambient+sun1+vertexlight
//   baseColorTexture: 1
//   normal: 1
//   ambient: ambient
//   suns: sun1
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
varying vec4 vToSun0;
varying vec3 vHalfSun0;

uniform vec3 uAmbient; // lights: linear radiance
uniform vec3 uSun0Radiance; // lights: linear irradiance / pi
uniform vec4 uBaseColor; // material: linear RGB and alpha
uniform float uNormalScale; // material: glTF's normalTexture.scale
uniform vec4 uReflectance; // material: 0.96 (1 - metalness), metalness, 0.04 (1 - metalness), 1 - 0.04 (1 - metalness)
uniform vec3 uLobe; // material: 1 - alpha^2, and the shadowing's coefficients

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

struct Sum {
  vec3 diffuse; // what the base colour tints, a metal's specular light included
  vec3 specular; // what it does not tint
};

struct View {
  vec3 normal; // N: any length, tangent space
  float inverseN; // 1 / |N|
  float nDotV; // N.V of unit vectors, kept off 0, where visibility would divide by it
};

struct Light {
  vec3 direction; // L: towards the light, unit, tangent space
  vec3 radiance; // irradiance / pi
  vec3 halfVector; // H' = V + L
  float fresnel; // F: Schlick's (1 - V.H)^5
};

// (N.H')^2 and |H'|^2 come out times |N|^2, which cancels in the lobe.
Angles anglesOf(Light light, View view) {
  float nDotL = max(dot(view.normal, light.direction) * view.inverseN, 0.0);
  float nDotH = dot(view.normal, light.halfVector);
  float h2 = dot(view.normal, view.normal) * dot(light.halfVector, light.halfVector);
  return Angles(nDotL, nDotL, nDotH * nDotH, h2, light.fresnel);
}

void addLight(Light light, View view, Surface surface, inout Sum sum) {
  // glTF 2.0, appendix B: its mix of a dielectric and a metal, sorted by what the base colour tints. Schlick's F is
  // F_0 (1 - x^5) + F_90 x^5, and F_90 is 1, which nothing tints.
  Angles angles = anglesOf(light, view);
  float weightF0 = angles.arriving - angles.arriving * angles.fresnel;
  float specular = specularLobe(angles, view.nDotV, surface);
  sum.diffuse += light.radiance * (weightF0 * (surface.metal * specular + surface.diffuse));
  sum.specular += light.radiance * (specular * (angles.arriving - weightF0 * surface.oneMinusF0));
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

  vec3 normal = texture2D(uNormalTexture, vUv0).xyz - 0.5;
  normal.xy *= uNormalScale;

  Surface surface;
  surface.diffuse = uReflectance.x;
  surface.metal = uReflectance.y;
  surface.oneMinusF0 = uReflectance.w;
  surface.slope = uLobe.x;
  surface.smith = uLobe.yz;
  surface.gain = 1.0; // folded into surface.smith

  vec3 irradiance = uAmbient;
  Sum sum;
  sum.diffuse = irradiance;
  sum.specular = vec3(0.0);

  float inverseN = inverseSquareRoot(dot(normal, normal));
  // N.V = N.H' - N.L, with H' = V + L of the first sun.
  float nDotV = max((dot(normal, vHalfSun0) - dot(normal, vToSun0.xyz)) * inverseN, 1.0e-4);
  View view = View(normal, inverseN, nDotV);

  addLight(Light(vToSun0.xyz, uSun0Radiance, vHalfSun0, vToSun0.w), view, surface, sum);

  vec3 color = base.rgb * sum.diffuse + sum.specular;

  color = linearToDisplay(color);
  gl_FragColor = vec4(color, 1.0);
}
