#version 100
// FrankenShader basecolor.metalrough.normal+sun2+punctual1+energy+decode-fast+srgb-fast+vc4
//   baseColorTexture: 1
//   metallicRoughness: metalrough
//   normal: 1
//   suns: sun2
//   punctualLights: punctual1
//   energy: 1
//   decode: decode-fast
//   output: srgb-fast
//   target: 1
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

uniform vec3 uSun0Direction; // lights: towards the sun, unit, world space
uniform vec3 uSun0Radiance; // lights: linear irradiance / pi
uniform vec3 uSun1Direction; // lights: towards the sun, unit, world space
uniform vec3 uSun1Radiance; // lights: linear irradiance / pi
uniform vec4 uPunctual0Position; // lights: from the eye, world space, m; 1 / range^2
uniform vec3 uPunctual0Radiance; // lights: linear intensity / pi
uniform vec3 uBaseColorCubic[3]; // material: coefficients of c^3, c^2 and c, times the factor
uniform vec2 uMetallicRoughness; // material: factors, 0-1

uniform sampler2D uBaseColorTexture; // material: RGB, sRGB unless decode-none, alpha
uniform sampler2D uNormalTexture; // material: tangent space, +Y up the texture, linear
uniform sampler2D uMetallicRoughnessTexture; // material: linear

float squareRoot(float x) {
  // VideoCore IV's rsq unit is followed by a Newton step, its exp2 and log2 are not. The exponent is a trace off
  // 1/2, or Mesa turns the expression back; over 1e-6 to 10 that is 1.4e-4 of the result.
  return exp2(0.50001 * log2(x));
}

float inverseSquareRoot(float x) {
  return inversesqrt(x);
}

float reciprocal(float x) {
  // Without the Newton step that follows VideoCore IV's rcp unit; a trace off 1, or Mesa turns it back.
  return exp2(-1.00001 * log2(x));
}

// texel: as stored. The frame's axes may have any length; x and y carry the map's scale.
vec3 mapNormal(vec3 texel, vec3 tangent, vec3 bitangent, vec3 normal) {
  vec3 n = texel - 0.5;
  n = n.x * tangent + n.y * bitangent + n.z * normal;
  return n * inverseSquareRoot(dot(n, n));
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
  vec3 direction; // towards the light, any length, world space
  vec3 radiance; // irradiance / pi where nothing attenuates it
  float inverseLength; // 1 / |direction|
  float attenuation; // by distance and cone
};

Angles anglesOf(Light light, View view) {
  // With unit vectors |V + L|^2 = 2 + 2 V.L, and N.(V + L) = N.V + N.L: H' = V + L is never built.
  float nDotL = max(dot(view.normal, light.direction) * light.inverseLength, 0.0);
  float nDotH = nDotL + view.nDotV;
  float h2 = dot(view.toCamera, light.direction) * light.inverseLength + 1.000001;
  h2 = h2 + h2; // a sum: VideoCore IV waits for its multiplier more than for its adder
  // squareRoot(0.25 * h2) with the quarter in the exponent, so that the lobe finds the same logarithm.
  float vDotH = exp2(0.50001 * log2(h2) - 1.0);
  return Angles(nDotL, nDotL * light.attenuation, nDotH * nDotH, h2, fresnel(vDotH));
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

// roughness: 0-1. slope: 1 - alpha^2. Returns 1 / E - 1, with the share E of a white sky's light that leaves after one
// reflection.
float compensationOf(float nDotV, float roughness, float slope) {
  // A fit to the albedo of GGX with height-correlated Smith shadowing, within 1 % of 1 / E (generator/docs/energy.md).
  float r = max(roughness, 0.001);
  float root = squareRoot(nDotV * (slope * nDotV) + (1.0 - slope)); // Smith's; compilers find alpha^2 in it
  float wide = log2(root + 3.0 * (r * r));
  return exp2(8.3048 + 8.5239 * log2(r) + (0.7861 * log2(nDotV) + 0.1981 * nDotV) + (1.4195 * r - 5.0816) * wide);
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

// The power part of the sRGB curve alone: below code 10 it is too dark. c: linear light, 0 and up.
vec3 linearToDisplay(vec3 c) {
  return exp2(log2(c) * (1.0 / 2.4) + 0.07724300) - 0.055;
}

void main() {
  vec4 base = texture2D(uBaseColorTexture, vUv0);
  base.rgb = base.rgb * (base.rgb * (base.rgb * uBaseColorCubic[0] + uBaseColorCubic[1]) + uBaseColorCubic[2]);

  vec3 normal = mapNormal(texture2D(uNormalTexture, vUv0).xyz, vTangent, vBitangent, vNormal);

  vec3 orm = texture2D(uMetallicRoughnessTexture, vUv0).rgb;
  float metallic = orm.b * uMetallicRoughness.x;
  float roughness = orm.g * uMetallicRoughness.y;

  Surface surface = surfaceOf(metallic, roughness);
  surface.base = base.rgb;

  Sum sum;
  sum.color = vec3(0.0);

  View view = viewOf(normal, vToCamera);

  surface.compensation = compensationOf(view.nDotV, roughness, surface.slope);

  addLight(Light(uSun0Direction, uSun0Radiance, 1.0, 1.0), view, surface, sum);
  addLight(Light(uSun1Direction, uSun1Radiance, 1.0, 1.0), view, surface, sum);
  addLight(pointLight(uPunctual0Position, uPunctual0Radiance, vToCamera), view, surface, sum);

  vec3 color = sum.color;

  color = linearToDisplay(color);
  gl_FragColor = vec4(color, 1.0);
}
