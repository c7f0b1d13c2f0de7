#version 100
// FrankenShader basecolor.metalrough+ambient+sun1+fast+energy+fp16
//   baseColorTexture: 1
//   metallicRoughness: metalrough
//   ambient: ambient
//   suns: sun1
//   brdf: fast
//   energy: 1
//   precision: 1
//
// FRAGMENT SHADER
//
precision mediump float;

varying vec2 vUv0;
varying vec3 vNormal;
varying vec3 vToCamera;

uniform vec3 uAmbient; // lights: linear radiance
uniform vec3 uSun0Direction; // lights: towards the sun, unit, world space
uniform vec3 uSun0Radiance; // lights: linear irradiance / pi
uniform vec4 uBaseColor; // material: linear RGB and alpha
uniform vec2 uMetallicRoughness; // material: factors, 0-1

uniform sampler2D uBaseColorTexture; // material: RGB, sRGB unless decode-none, alpha
uniform sampler2D uMetallicRoughnessTexture; // material: linear

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

// The denominator of V = 0.5 / denominatorV; packMaterial and surfaceOf fold alpha^2 / 2 into it.
float denominatorV(Angles angles, float nDotV, Surface surface) {
  // Hammon, "PBR Diffuse Lighting for GGX+Smith Microsurfaces", 2017: mix(2 N.L N.V, N.L + N.V, alpha).
  return angles.nDotL * nDotV * surface.smith.x + (angles.nDotL + nDotV) * surface.smith.y;
}

// Returns pi D V, at most 500: what is brighter is white in any light.
float specularLobe(Angles angles, float nDotV, Surface surface) {
  float peak = angles.h2 * reciprocal(denominatorD(angles, surface)); // 1 to 1 / alpha^2
  return min((surface.gain * peak) * peak * reciprocal(denominatorV(angles, nDotV, surface)), 500.0);
}

// metallic, roughness: 0-1. The roughness is kept off 0, where a sun's highlight has no size.
Surface surfaceOf(float metallic, float roughness) {
  float r = max(roughness, 0.001);
  float alpha = r * r;
  float alpha2 = alpha * alpha;
  Surface surface;
  surface.smith = vec2(2.0 - 2.0 * alpha, alpha); // first: saves 9 instructions on VideoCore IV
  surface.diffuse = 0.96 - 0.96 * metallic;
  surface.metal = metallic;
  surface.oneMinusF0 = 0.96 + 0.04 * metallic;
  surface.slope = 1.0 - alpha2;
  surface.gain = 0.5 * alpha2;
  return surface;
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
  vec3 halfVector = view.toCamera + light.direction;
  vec3 crossed = cross(view.normal, halfVector);
  float h2 = max(dot(halfVector, halfVector), 0.01);
  float nDotL = max(dot(view.normal, light.direction), 0.0);
  float nDotH = nDotL + view.nDotV;
  return Angles(nDotL, nDotL, nDotH * nDotH, dot(crossed, crossed), h2, fresnel(squareRoot(0.25 * h2)));
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

// roughness: 0.3-1. alpha2: roughness^4. Returns 1 / E - 1, with the share E of a white sky's light that leaves after
// one reflection.
float compensationOf(float nDotV, float roughness, float alpha2) {
  // A fit to the albedo of GGX with height-correlated Smith shadowing, within 1 % of 1 / E (generator/docs/energy.md).
  float root = squareRoot(nDotV * nDotV * (1.0 - alpha2) + alpha2); // Smith's
  float wide = log2(root + 3.0 * (roughness * roughness));
  float narrow = 0.7861 * log2(nDotV) + 0.1981 * nDotV;
  return exp2(8.3048 + 8.5239 * log2(roughness) + narrow + (1.4195 * roughness - 5.0816) * wide);
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

  vec3 normal = vNormal * inverseSquareRoot(dot(vNormal, vNormal));

  vec3 orm = texture2D(uMetallicRoughnessTexture, vUv0).rgb;
  float metallic = orm.b * uMetallicRoughness.x;
  float roughness = orm.g * uMetallicRoughness.y;
  roughness = max(roughness, 0.3);

  Surface surface = surfaceOf(metallic, roughness);
  surface.base = base.rgb;
  surface.slope = (roughness * roughness) * (roughness * roughness); // alpha^2: 1 - alpha^2 has too few digits

  vec3 irradiance = uAmbient;
  Sum sum;
  sum.color = base.rgb * irradiance;

  View view = viewOf(normal, vToCamera);

  surface.compensation = compensationOf(view.nDotV, roughness, surface.slope);

  addLight(Light(uSun0Direction, uSun0Radiance), view, surface, sum);

  vec3 color = sum.color;

  color = linearToDisplay(color);
  gl_FragColor = vec4(color, 1.0);
}
