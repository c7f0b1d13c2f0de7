#version 100
// FrankenShader basecolor.normal+punctual2+spots
//   baseColorTexture: 1
//   normal: 1
//   punctualLights: punctual2
//   spots: 1
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

uniform vec4 uPunctual0Position; // lights: from the eye, world space, m; 1 / range^2
uniform vec3 uPunctual0Radiance; // lights: linear intensity / pi
uniform vec3 uPunctual0Axis; // lights: where it shines, unit, world space
uniform vec2 uPunctual0Cone; // lights: scale and offset
uniform vec4 uPunctual1Position; // lights: from the eye, world space, m; 1 / range^2
uniform vec3 uPunctual1Radiance; // lights: linear intensity / pi
uniform vec3 uPunctual1Axis; // lights: where it shines, unit, world space
uniform vec2 uPunctual1Cone; // lights: scale and offset
uniform vec4 uBaseColor; // material: linear RGB and alpha
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

// texel: as stored. The frame's axes may have any length; x and y carry the map's scale.
vec3 mapNormal(vec3 texel, vec3 tangent, vec3 bitangent, vec3 normal) {
  vec3 n = texel - 0.5;
  n = n.x * tangent + n.y * bitangent + n.z * normal;
  return n * inverseSquareRoot(dot(n, n));
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
  vec3 direction; // towards the light, any length, world space
  vec3 radiance; // irradiance / pi where nothing attenuates it
  float inverseLength; // 1 / |direction|
  float attenuation; // by distance and cone
};

Angles anglesOf(Light light, View view) {
  // With unit vectors |V + L|^2 = 2 + 2 V.L, and N.(V + L) = N.V + N.L: H' = V + L is never built.
  float h2 = dot(view.toCamera, light.direction) * light.inverseLength * 2.0 + 2.000002;
  float nDotL = max(dot(view.normal, light.direction) * light.inverseLength, 0.0);
  float nDotH = nDotL + view.nDotV;
  return Angles(nDotL, nDotL * light.attenuation, nDotH * nDotH, h2, fresnel(squareRoot(0.25 * h2)));
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

// position: from the eye, world space, m; 1 / range^2, 0 where the range is infinite. intensity: over pi. toCamera:
// from the surface, m.
Light pointLight(vec4 position, vec3 intensity, vec3 toCamera) {
  vec3 toLight = position.xyz + toCamera;
  float distance2 = max(dot(toLight, toLight), 1.0e-8);
  float inverseLength = inverseSquareRoot(distance2);
  // Inverse square with a window at the range: KHR_lights_punctual, "Range Property".
  float d = distance2 * position.w;
  float attenuation = max(1.0 - d * d, 0.0) * (inverseLength * inverseLength);
  return Light(toLight, intensity, inverseLength, attenuation);
}

// cosine: of the angle between the axis and the way to the light. cone: scale and offset that packPunctualLight made
// from both angles.
float coneAttenuation(float cosine, vec2 cone) {
  // KHR_lights_punctual, "Inner and Outer Cone Angles".
  float c = clamp(cone.y - cosine * cone.x, 0.0, 1.0);
  return c * c;
}

// axis: where the light shines, unit. See pointLight and coneAttenuation.
Light spotLight(vec4 position, vec3 intensity, vec3 axis, vec2 cone, vec3 toCamera) {
  Light light = pointLight(position, intensity, toCamera);
  light.attenuation *= coneAttenuation(dot(light.direction, axis) * light.inverseLength, cone);
  return light;
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

  vec3 normal = mapNormal(texture2D(uNormalTexture, vUv0).xyz, vTangent, vBitangent, vNormal);

  Surface surface;
  surface.diffuse = uReflectance.x;
  surface.metal = uReflectance.y;
  surface.oneMinusF0 = uReflectance.w;
  surface.slope = uLobe.x;
  surface.smith = uLobe.yz;
  surface.gain = 1.0; // folded into surface.smith

  Sum sum;
  sum.diffuse = vec3(0.0);
  sum.specular = vec3(0.0);

  View view = viewOf(normal, vToCamera);

  Light spotPunctual0 = spotLight(uPunctual0Position, uPunctual0Radiance, uPunctual0Axis, uPunctual0Cone, vToCamera);
  addLight(spotPunctual0, view, surface, sum);
  Light spotPunctual1 = spotLight(uPunctual1Position, uPunctual1Radiance, uPunctual1Axis, uPunctual1Cone, vToCamera);
  addLight(spotPunctual1, view, surface, sum);

  vec3 color = base.rgb * sum.diffuse + sum.specular;

  color = linearToDisplay(color);
  gl_FragColor = vec4(color, 1.0);
}
