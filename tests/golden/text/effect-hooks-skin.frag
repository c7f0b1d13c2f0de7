#version 100
// FrankenShader sun1+hooks@bd548b9c
//   suns: sun1
//   effect: hooks
//
// FRAGMENT SHADER
//
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif

varying vec3 vNormal;
varying vec3 vToCamera;
varying float vHeight;

uniform vec3 uSun0Direction; // lights: towards the sun, unit, world space
uniform vec3 uSun0Radiance; // lights: linear irradiance / pi
uniform vec4 uBaseColor; // material: linear RGB and alpha
uniform vec2 uMetallicRoughness; // material: factors, 0-1
uniform vec4 uTint; // user: factor

float squareRoot(float x) {
  return sqrt(x);
}

float inverseSquareRoot(float x) {
  return inversesqrt(x);
}

float reciprocal(float x) {
  return 1.0 / x;
}

vec4 onBaseColor(vec4 base) {
  return base * uTint;
}

const float kWet = 0.25;

float wetness(float roughness) {
  return roughness * kWet;
}

void onSurface(inout vec3 normal, inout float roughness) {
  normal = normalize(normal + vec3(0.0, 0.1, 0.0));
  roughness = wetness(roughness);
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

struct Sum {
  vec3 diffuse; // what the base colour tints, a metal's specular light included
  vec3 specular; // what it does not tint
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
  // glTF 2.0, appendix B: its mix of a dielectric and a metal, sorted by what the base colour tints. Schlick's F is
  // F_0 (1 - x^5) + F_90 x^5, and F_90 is 1, which nothing tints.
  Angles angles = anglesOf(light, view);
  float weightF0 = angles.arriving - angles.arriving * angles.fresnel;
  float specular = specularLobe(angles, view.nDotV, surface);
  sum.diffuse += light.radiance * (weightF0 * (surface.metal * specular + surface.diffuse));
  sum.specular += light.radiance * (specular * (angles.arriving - weightF0 * surface.oneMinusF0));
}

vec3 onLight(vec3 color) {
  return color * (uTint.w + vHeight);
}

// The sRGB transfer curve (IEC 61966-2-1). c: linear light; clipped at 0 and 1. Returns codes, 0-1.
vec3 linearToDisplay(vec3 c) {
  c = clamp(c, 0.0, 1.0);
  vec3 high = 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055;
  return mix(high, 12.92 * c, step(c, vec3(0.0031308)));
}

void main() {
  vec4 base = uBaseColor;

  base = onBaseColor(base);

  vec3 normal = vNormal * inverseSquareRoot(dot(vNormal, vNormal));

  float metallic = uMetallicRoughness.x;
  float roughness = uMetallicRoughness.y;

  onSurface(normal, roughness);

  Surface surface = surfaceOf(metallic, roughness);

  Sum sum;
  sum.diffuse = vec3(0.0);
  sum.specular = vec3(0.0);

  View view = viewOf(normal, vToCamera);

  addLight(Light(uSun0Direction, uSun0Radiance), view, surface, sum);

  vec3 color = base.rgb * sum.diffuse + sum.specular;

  color = onLight(color);

  color = linearToDisplay(color);
  gl_FragColor = vec4(color, 1.0);
}
