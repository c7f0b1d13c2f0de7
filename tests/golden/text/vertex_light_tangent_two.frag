#version 100
// FrankenShader
//   baseColorTexture: 1
//   metallicRoughness: metalrough
//   normal: 1
//   sides: 1
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
uniform sampler2D uBaseColorTexture; // material: RGB as `decode` says, alpha
uniform vec4 uBaseColor; // material: linear RGB and alpha
uniform sampler2D uNormalTexture; // material: tangent space, +Y up the texture, linear
uniform float uNormalScale; // material: glTF's normalTexture.scale
uniform sampler2D uMetallicRoughnessTexture; // material: linear
uniform vec2 uMetallicRoughness; // material: factors, 0-1
varying vec4 vToSun0;
varying vec3 vHalfSun0;
varying vec4 vToSun1;
varying vec3 vHalfSun1;
uniform vec3 uSun0Radiance; // lights: linear irradiance / pi
uniform vec3 uSun1Radiance; // lights: linear irradiance / pi

// The inverse of the sRGB transfer curve (IEC 61966-2-1). c: codes, 0-1. Returns linear light, 0-1.
vec3 decodeSrgb(vec3 c) {
  vec3 low = c * (1.0 / 12.92);
  vec3 high = pow(c * (1.0 / 1.055) + 0.055 / 1.055, vec3(2.4));
  return mix(high, low, step(c, vec3(0.04045)));
}

float root(float x) {
  return sqrt(x);
}

float inverseRoot(float x) {
  return inversesqrt(x);
}

float inverse(float x) {
  return 1.0 / x;
}

struct Surface {
  float diffuse; // 0.96 (1 - metalness): what a dielectric lets in and scatters
  float metal; // metalness
  float clear; // 1 - 0.04 (1 - metalness): what is not mirrored without a tint
  float slope; // 1 - alpha^2
  vec2 smith; // coefficients of the shadowing, by BRDF
  float gain; // what the shadowing's coefficients do not hold
};

// pi D V. light: see lightAngles.
float lobe(vec4 light, float nDotV, Surface surface) {
  float width = light.z - light.y * surface.slope;
  float smithL = nDotV * root(light.x * (light.x * surface.smith.x) + surface.smith.y);
  float smithV = light.x * root(nDotV * (surface.smith.x * nDotV) + surface.smith.y);
  return (light.z * light.z) * surface.gain * inverse((smithV + smithL) * (width * width));
}

// light: see lightAngles. radiance: irradiance / pi.
void addLight(vec3 radiance, vec4 light, float nDotV, Surface surface, inout vec3 diffuse, inout vec3 specular) {
  float entering = light.x - light.x * light.w;
  float mirror = lobe(light, nDotV, surface);
  diffuse += radiance * (entering * (surface.metal * mirror + surface.diffuse));
  specular += radiance * (mirror * (light.x - entering * surface.clear));
}

// metallic, roughness: 0-1. The roughness is kept off 0, where a sun's mirror image has no size.
Surface makeSurface(float metallic, float roughness) {
  float r = max(roughness, 0.001);
  float alpha2 = (r * (r * r)) * r;
  float slope = 1.0 - alpha2;
  return Surface(0.96 - 0.96 * metallic, metallic, 0.96 + 0.04 * metallic, slope, vec2(slope, alpha2), 0.5 * alpha2);
}

// normal: any length; the scale that it brings into (N.H)^2 and |H|^2 cancels in the BRDF.
vec4 lightAngles(vec3 normal, float inverseLength, vec4 toLight, vec3 halfVector) {
  float nDotL = max(dot(normal, toLight.xyz) * inverseLength, 0.0);
  float nDotH = dot(normal, halfVector);
  return vec4(nDotL, nDotH * nDotH, dot(normal, normal) * dot(halfVector, halfVector), toLight.w);
}

// The sRGB transfer curve (IEC 61966-2-1). c: linear light; clipped at 0 and 1. Returns codes, 0-1.
vec3 encodeDisplay(vec3 c) {
  c = clamp(c, 0.0, 1.0);
  vec3 high = 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055;
  return mix(high, 12.92 * c, step(c, vec3(0.0031308)));
}

void main() {
  vec4 base = texture2D(uBaseColorTexture, vUv0);
  base.rgb = decodeSrgb(base.rgb);
  base *= uBaseColor;
  vec3 normal = texture2D(uNormalTexture, vUv0).xyz - 0.5;
  normal.xy *= uNormalScale;
  if (!gl_FrontFacing) normal = -normal;
  vec3 orm = texture2D(uMetallicRoughnessTexture, vUv0).rgb;
  float metallic = orm.b * uMetallicRoughness.x;
  float roughness = orm.g * uMetallicRoughness.y;
  Surface surface = makeSurface(metallic, roughness);
  vec3 diffuse = vec3(0.0);
  vec3 specular = vec3(0.0);
  float inverseLength = inverseRoot(dot(normal, normal));
  float nDotV = max((dot(normal, vHalfSun0) - dot(normal, vToSun0.xyz)) * inverseLength, 1.0e-4);
  vec4 anglesSun0 = lightAngles(normal, inverseLength, vToSun0, vHalfSun0);
  addLight(uSun0Radiance, anglesSun0, nDotV, surface, diffuse, specular);
  vec4 anglesSun1 = lightAngles(normal, inverseLength, vToSun1, vHalfSun1);
  addLight(uSun1Radiance, anglesSun1, nDotV, surface, diffuse, specular);
  vec3 color = base.rgb * diffuse + specular;
  color = encodeDisplay(color);
  gl_FragColor = vec4(color, 1.0);
}
