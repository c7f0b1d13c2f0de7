#version 100
// FrankenShader punctual1+schlick+fp16
//   punctualLights: punctual1
//   brdf: schlick
//   precision: 1
//
// FRAGMENT SHADER
//
precision mediump float;

varying vec3 vNormal;
varying vec3 vToCamera;
varying vec3 vToPunctual0;

uniform vec3 uPunctual0Radiance; // lights: linear intensity / pi, times the square of the scale
uniform float uPunctual0Window; // lights: 1 / range^2, over the square of the scale
uniform vec4 uBaseColor; // material: linear RGB and alpha
uniform vec2 uMetallicRoughness; // material: factors, 0-1
uniform vec4 uReflectance; // material: 0.96 (1 - metalness), metalness, 0.04 (1 - metalness), 1 - 0.04 (1 - metalness)
uniform vec3 uLobe; // material: 1 - alpha^2, and the shadowing's coefficients

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
  float sine2; // |N x H'|^2
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

// The denominator d of pi D = alpha^2 |H'|^4 / d^2. surface.slope holds alpha^2 here: surface/slope.fp16.
float denominatorD(Angles angles, Surface surface) {
  // GGX: Walter et al., "Microfacet Models for Refraction through Rough Surfaces", 2007, equation 33. Its
  // |H'|^2 - (N.H')^2 is |N x H'|^2 by Lagrange's identity: as a difference it would have too few digits.
  return angles.nDotH2 * surface.slope + angles.sine2;
}

// nDotX: N.L or N.V. smith: 1 - k and k.
float shadowing(float nDotX, vec2 smith) {
  // The denominator of Schlick's G_1, N.X / (N.X (1 - k) + k): Karis, "Real Shading in Unreal Engine 4", 2013.
  // k = alpha / 2, and (roughness + 1)^2 / 8 for the BRDF `seed`.
  return smith.x * nDotX + smith.y;
}

// The denominator of V = 0.25 / denominatorV; packMaterial and surfaceOf fold alpha^2 / 4 into it.
float denominatorV(Angles angles, float nDotV, Surface surface) {
  return shadowing(nDotV, surface.smith) * shadowing(angles.nDotL, surface.smith);
}

// Returns pi D V, at most 500: what is brighter is white in any light.
float specularLobe(Angles angles, float nDotV, Surface surface) {
  float peak = angles.h2 * reciprocal(denominatorD(angles, surface)); // 1 to 1 / alpha^2
  return min((surface.gain * peak) * peak * reciprocal(denominatorV(angles, nDotV, surface)), 500.0);
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
  vec3 halfVector = view.toCamera + light.direction;
  vec3 crossed = cross(view.normal, halfVector);
  float h2 = max(dot(halfVector, halfVector), 0.01);
  float nDotL = max(dot(view.normal, light.direction), 0.0);
  float nDotH = nDotL + view.nDotV;
  return Angles(nDotL, nDotL, nDotH * nDotH, dot(crossed, crossed), h2, fresnel(squareRoot(0.25 * h2)));
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

// distance2, inverseRange2: in squares of the scaled unit; inverseRange2 is 0 where the range is infinite.
float distanceAttenuation(float distance2, float inverseRange2) {
  // Inverse square with a window at the range: KHR_lights_punctual, "Range Property". The ratio is clipped before it is
  // squared, which could overflow.
  float d = min(distance2 * inverseRange2, 1.0);
  return (1.0 - d * d) / distance2;
}

// toLight: scaled, at most 60 long. intensity: over pi. The radiance ends where any surface is white.
Light pointLight(vec3 toLight, vec3 intensity, float inverseRange2) {
  float distance2 = max(dot(toLight, toLight), 1.0e-4);
  vec3 direction = toLight * inverseSquareRoot(distance2);
  return Light(direction, min(intensity * distanceAttenuation(distance2, inverseRange2), 16.0));
}

// The sRGB transfer curve (IEC 61966-2-1). c: linear light; clipped at 0 and 1. Returns codes, 0-1.
vec3 linearToDisplay(vec3 c) {
  c = clamp(c, 0.0, 1.0);
  vec3 high = 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055;
  return mix(high, 12.92 * c, step(c, vec3(0.0031308)));
}

void main() {
  vec4 base = uBaseColor;

  vec3 normal = vNormal * inverseSquareRoot(dot(vNormal, vNormal));

  float roughness = uMetallicRoughness.y;

  Surface surface;
  surface.diffuse = uReflectance.x;
  surface.metal = uReflectance.y;
  surface.oneMinusF0 = uReflectance.w;
  surface.slope = uLobe.x;
  surface.smith = uLobe.yz;
  surface.gain = 1.0; // folded into surface.smith
  surface.slope = (roughness * roughness) * (roughness * roughness); // alpha^2: 1 - alpha^2 has too few digits

  Sum sum;
  sum.diffuse = vec3(0.0);
  sum.specular = vec3(0.0);

  View view = viewOf(normal, vToCamera);

  addLight(pointLight(vToPunctual0, uPunctual0Radiance, uPunctual0Window), view, surface, sum);

  vec3 color = base.rgb * sum.diffuse + sum.specular;

  color = linearToDisplay(color);
  gl_FragColor = vec4(color, 1.0);
}
