#version 100
// FrankenShader basecolor.metalrough.normal.occlusion-packed.emissive+ambient+sun2+decode-fast+srgb-fast+vc4
//   baseColorTexture: 1
//   metallicRoughness: metalrough
//   normal: 1
//   occlusion: occlusion-packed
//   emissive: emissive
//   ambient: ambient
//   suns: sun2
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

uniform vec3 uAmbient; // lights: linear radiance
uniform vec3 uSun0Direction; // lights: towards the sun, unit, world space
uniform vec3 uSun0Radiance; // lights: linear irradiance / pi
uniform vec3 uSun1Direction; // lights: towards the sun, unit, world space
uniform vec3 uSun1Radiance; // lights: linear irradiance / pi
uniform vec3 uBaseColorCubic[3]; // material: coefficients of c^3, c^2 and c, times the factor
uniform vec2 uMetallicRoughness; // material: factors, 0-1
uniform vec3 uEmissiveCubic[3]; // material: coefficients of c^3, c^2 and c, times the radiance of white
uniform vec2 uOcclusion; // material: strength, 1 - strength

uniform sampler2D uBaseColorTexture; // material: RGB, sRGB unless decode-none, alpha
uniform sampler2D uNormalTexture; // material: tangent space, +Y up the texture, linear
uniform sampler2D uMetallicRoughnessTexture; // material: linear
uniform sampler2D uEmissiveTexture; // material: RGB, sRGB unless decode-none

float squareRoot(float x) {
  // VideoCore IV's rsq unit is followed by a Newton step, its exp2 and log2 are not. The exponent is a trace off
  // 1/2, or Mesa turns the expression back; over 1e-6 to 10 that is 1.4e-4 of the result.
  return exp2(0.50001 * log2(x));
}

float inverseSquareRoot(float x) {
  // Without the Newton step that follows VideoCore IV's rsq unit; a trace off 1/2, or Mesa turns it back.
  return exp2(-0.50001 * log2(x));
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
  float h = log2(angles.h2); // a product less than a reciprocal, and lights/light.vc4 has taken it already
  return surface.gain * exp2((h + h) - log2(denominator));
}

// metallic, roughness: 0-1. The roughness is kept off 0, where a sun's highlight has no size.
Surface surfaceOf(float metallic, float roughness) {
  float r = max(roughness, 0.001);
  float alpha2 = (r * r) * (r * r);
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
  vec3 normal; // N: any length, world space
  vec3 toCamera; // V: any length, world space
  float inverseN; // 1 / |N|
  float inverseV; // 1 / |V|
  float n2; // |N|^2
  float v2; // 1 + |V|^2 of the scaled V, kept off 2
  float facing; // N.V of the scaled V
  float nDotV; // N.V of unit vectors, kept off 0, where visibility would divide by it
};

View viewOf(vec3 normal, vec3 toCamera) {
  float n2 = dot(normal, normal);
  float v2 = dot(toCamera, toCamera);
  float inverseN = inverseSquareRoot(n2);
  float inverseV = inverseSquareRoot(v2);
  v2 = v2 * (inverseV * inverseV) + 1.000002;
  float facing = max(dot(normal, toCamera) * inverseV, 5.0e-5);
  return View(normal, toCamera, inverseN, inverseV, n2, v2, facing, facing * inverseN);
}

struct Light {
  vec3 direction; // L: towards the light, unit, world space
  vec3 radiance; // irradiance / pi
};

// (N.H')^2 and |H'|^2 come out times |N|^2, which cancels in the lobe.
Angles anglesOf(Light light, View view) {
  // |V + L|^2 = |V|^2 + 1 + 2 V.L, and N.(V + L) = N.V + N.L: H' = V + L is never built.
  float facingLight = max(dot(view.normal, light.direction), 0.0);
  float nDotH = facingLight + view.facing;
  float vDotL = dot(view.toCamera, light.direction) * view.inverseV;
  float h2 = (vDotL + view.v2) + vDotL;
  float nDotL = facingLight * view.inverseN;
  return Angles(nDotL, nDotL, nDotH * nDotH, view.n2 * h2, fresnel(squareRoot(0.25 * h2)));
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

// The power part of the sRGB curve alone: below code 10 it is too dark. c: linear light, 0 and up.
vec3 linearToDisplay(vec3 c) {
  return exp2(log2(c) * (1.0 / 2.4) + 0.07724300) - 0.055;
}

void main() {
  vec4 base = texture2D(uBaseColorTexture, vUv0);
  base.rgb = base.rgb * (base.rgb * (base.rgb * uBaseColorCubic[0] + uBaseColorCubic[1]) + uBaseColorCubic[2]);

  vec3 texel = texture2D(uNormalTexture, vUv0).xyz - 0.5;
  vec3 normal = texel.x * vTangent + texel.y * vBitangent + texel.z * vNormal;

  vec3 orm = texture2D(uMetallicRoughnessTexture, vUv0).rgb;
  float metallic = orm.b * uMetallicRoughness.x;
  float roughness = orm.g * uMetallicRoughness.y;

  Surface surface = surfaceOf(metallic, roughness);

  vec3 irradiance = uAmbient;
  Sum sum;
  sum.diffuse = vec3(0.0);
  sum.specular = vec3(0.0);

  vec3 glow = texture2D(uEmissiveTexture, vUv0).rgb;
  sum.specular += glow * (glow * (glow * uEmissiveCubic[0] + uEmissiveCubic[1]) + uEmissiveCubic[2]);

  View view = viewOf(normal, vToCamera);

  addLight(Light(uSun0Direction, uSun0Radiance), view, surface, sum);
  addLight(Light(uSun1Direction, uSun1Radiance), view, surface, sum);

  float occlusion = orm.r * uOcclusion.x + uOcclusion.y;

  sum.diffuse += irradiance * occlusion;

  vec3 color = base.rgb * sum.diffuse + sum.specular;

  color = linearToDisplay(color);
  gl_FragColor = vec4(color, 1.0);
}
